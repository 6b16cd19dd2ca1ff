# The mass is lost at the start. Cases of the paper.
x_name = "speed at the mass loss, Hz"
$cases << END
150,0.3
150,0.2
150,0.08
100,0.3
75,0.3
49.8,0.3
11.8,0.3
END
