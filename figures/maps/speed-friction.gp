# Reasons one and four: high speed at the mass loss, high friction.
heading = "Speed at the mass loss and friction"
abscissa = "start_speed_hz"; x_name = "speed at the mass loss, Hz"
ordinate = "friction";       y_name = "coefficient of friction μ"
$cases << END
150,0.3
150,0.2
150,0.08
100,0.3
75,0.3
49.8,0.3
11.8,0.3
END
