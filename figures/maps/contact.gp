# What the text calls minor: stiffness and damping of the contact.
heading = "Stiffness and damping of the contact"
abscissa = "contact_stiffness"; x_name = "contact stiffness k_t, N/m"; x_log = 1
ordinate = "contact_damping";   y_name = "contact damping d_t, N s/m"; y_log = 1
rows = 2; name_of_row(unused) = ", μ = ".strcol("friction")
