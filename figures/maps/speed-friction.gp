# Reasons one and four: high speed at the mass loss, high friction.
heading = "Speed at the mass loss and friction"
abscissa = "start_speed_hz"; x_name = "speed at the mass loss, Hz"
ordinate = "friction";       y_name = "coefficient of friction μ"
