# F_n after a mass loss at a lower speed.
stats data using "speed_Hz" name "driven" nooutput
set title caption(12, "Radial force F_n, ".loss("run"), \
  friction("run").", ".stiffness("run").", ".motor("run", driven_max))
set xlabel "t, s"
set ylabel "F_n, kN"
set format x "%.2f"
set arrow from graph 0,first -237 to graph 1,first -237 nohead linestyle published
set label "paper: 237 kN" at graph 0.02,first -237 offset 0,0.7 textcolor rgb grey
eval table(0.02, 0.55, 8)
eval row(1, "f at t_1", "100 Hz"); eval row(2, "largest |F_n|", "237 kN"); eval row(3, "reached at", "")
do for [set in sets] {
  eval use(set)
  stats data using "time_s":(column("normal_force_N")/1e3) name "F" nooutput
  stats data every ::0::0 using "speed_Hz" name "f" nooutput
  eval ours_in(1, sprintf("%.1f Hz", f_max)); eval ours_in(2, sprintf("%.1f kN", -F_min_y))
  eval ours_in(3, sprintf("%.4f s", F_pos_min_y))
  eval mark_law("run")
  eval label_curve(short_of(set), F_pos_min_y, -150, is_printed(set) ? "left offset 1,0" : "right offset -3,0")
}
plot [19.1:19.2] [-280:0] @each_set using "time_s":(column("normal_force_N")/1e3) @layered
