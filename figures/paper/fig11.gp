# F_n for three contact stiffnesses.
set title caption(11, "Influence of the contact stiffness on the radial force F_n", \
  friction("k_t").", ".stiffness("k_t").", ".loss("k_t"))
set multiplot layout 3,1 margins 0.115,0.97,0.11,0.87 spacing 0,0.035
set ytics -400,200,0
set ylabel "F_n, kN"
set format x ""
force(name) = of_run(name, "normal_force_N")/1e3
runs = "'k_t' '2 k_t' '0.5 k_t'"
do for [i = 1:3] {
  name = word(runs, i)
  unset label; unset arrow
  set arrow from graph 0,first -455 to graph 1,first -455 nohead linestyle published
  eval table(0.01, 0.68, 5)
  set label "{/:Bold ".name."}" at graph 0.01,0.68 left boxed front
  eval row(1, "largest |F_n|", i == 1 ? "455 kN" : "")
  if (i > 1) { eval row(2, "change", "minor") }
  do for [set in sets] {
    eval use(set)
    stats data using (force("k_t")) name "usual" nooutput
    stats data using (force(name)) name "F" nooutput
    eval ours_in(1, sprintf("%.1f kN", -F_min))
    if (i == 1) { eval label_curve(short_of(set), is_printed(set) ? 29.154 : 29.134, is_printed(set) ? -270 : -230, "left") }
    if (i > 1) { eval ours_in(2, signed("%.0f", 100*(F_min/usual_min - 1))." %") }
  }
  if (i == 2) { unset title }
  if (i == 3) { set xlabel "t, s" offset 0,0.4; set format x "%.2f" }
  plot [29.1:29.16] [-560:0] @each_set using (of_run(name, "time_s")):(force(name)) @layered
}
