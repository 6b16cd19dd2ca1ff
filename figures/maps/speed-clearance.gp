# The mass is lost at the start. Cases of the paper.
x_name = "speed at the mass loss, Hz"
$cases << END
150,3
100,3
75,3
49.8,3
11.8,3
END
