# O starts at the ring.
$border << END
-3,-6
-3,6

3,-6
3,6
END
border_words = "O starts at the ring: clearance 3 mm"
