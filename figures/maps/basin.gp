# Basins of attraction at constant speed.
heading = "Start of a rotor at a constant 150 Hz"
abscissa = "start_x";          x_name = "displacement of O at the start, mm"; x_unit = 1e-3
ordinate = "start_velocity_y"; y_name = "velocity of O across it, m/s"
panels = "friction"; panel_format = "μ = %g"
