# Reasons one and three: high speed at the mass loss, small clearance.
heading = "Speed at the mass loss and clearance"
abscissa = "start_speed_hz"; x_name = "speed at the mass loss, Hz"
ordinate = "clearance";      y_name = "clearance, mm"; y_unit = 1e-3
$cases << END
150,3
100,3
75,3
49.8,3
11.8,3
END
