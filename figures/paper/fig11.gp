# F_n for three contact stiffnesses.
set title caption(11, "Influence of the contact stiffness on the radial force F_n", \
  friction("k_t").", ".stiffness("k_t").", ".loss("k_t"))
set multiplot layout 3,1 margins 0.115,0.97,0.11,0.87 spacing 0,0.035
set xrange [29.1:29.16]
set yrange [-560:0]
set ytics -400,200,0
set ylabel "F_n, kN"
set format x ""
force(name) = of_run(name, "normal_force_N")/1e3
stats data using (force("k_t")) name "reference" nooutput
set arrow from graph 0,first -455 to graph 1,first -455 nohead linestyle published
runs = "'k_t' '2 k_t' '0.5 k_t'"
do for [i = 1:3] {
  name = word(runs, i)
  stats data using (force(name)) name "F" nooutput
  set label 1 "{/:Bold ".name."}" at graph 0.02,0.7 boxed front
  change = i == 1 ? "" : sprintf(", %s %%", signed("%.0f", 100*(F_min/reference_min - 1)))
  set label 2 sprintf("largest |F_n|: %.1f kN%s", -F_min, change) at graph 0.02,0.49 boxed front
  set label 3 (i == 1 ? "paper: 455 kN" : "paper: minor effect (dashed: 455 kN)") at graph 0.02,0.28 \
    textcolor rgb grey boxed front
  if (i == 2) { unset title }
  if (i == 3) { set xlabel "t, s" offset 0,0.4; set format x "%.2f" }
  its_run = name
  plot data using (of_run(name, "time_s")):(force(name)) with lines linestyle ours notitle @digitised
}
