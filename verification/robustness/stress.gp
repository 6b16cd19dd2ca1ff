# Stability of the published method's steps. The caller sets what style.gp needs.
set title "{/:Bold Largest stable step of the published method} (lines: linear theory of a straight ring)"
set logscale xy
set format x "10^{%T}"
set format y "10^{%T}"
set xlabel "contact stiffness k_t, N/m"
set ylabel "step, s"
set key top right
dampings = "0 10000 1000000 10000000"
of(d, c) = column("contact_damping_Ns_per_m") == d ? column(c) : NaN
k_t = "contact_stiffness_N_per_m"
set arrow from 8e8, graph 0 to 8e8, graph 1 nohead linestyle published
set label "the paper's k_t" at 8e8, graph 0.96 offset 0.5,0
set arrow from graph 0, first 5e-6 to graph 1, first 5e-6 nohead linestyle published
set label "and step" at graph 0.02, first 5e-6 offset 0,0.6
plot for [i = 1:words(dampings)] data using (column(k_t)):(of(word(dampings, i) + 0, "linear_theory_s")) \
       with lines linetype i notitle, \
     for [i = 1:words(dampings)] data using (column(k_t)):(of(word(dampings, i) + 0, "limit_s")) \
       with points pointtype 4 + i linetype i title sprintf("d_t = %.0e N s/m", word(dampings, i) + 0)
