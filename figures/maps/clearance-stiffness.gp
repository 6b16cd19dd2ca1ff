# Reasons three and two: small clearance, compliant supports.
heading = "Clearance and stiffness of the supports"
abscissa = "clearance";         x_name = "clearance, mm"; x_unit = 1e-3
ordinate = "support_stiffness"; y_name = "stiffness of the supports k, N/m"; y_log = 1
