# F_n from separate collisions to continuous contact.
set title caption(5, "Impact force F_n from separate collisions to continuous contact", \
  friction("run").", ".loss("run"))
set xlabel "t, s"
set ylabel "F_n, kN"
set format x "%.3f"
force = 'column("normal_force_N")/1e3'
eval table(0.02, 0.72, 19)
eval row(1, "largest |F_n|", "455 kN")
eval row(2, "first contact to rolling", "23 ms")
eval row(3, "from then to largest |F_n|", "0")
do for [set in sets] {
  eval use(set)
  onset = number("run", "rolling_onset_s"); eval set."_onset = onset"
  set arrow from onset,graph 0 to onset,graph 1 nohead linestyle event
  eval ours_in(1, sprintf("%.1f kN", 1e-3*number("run", "peak_normal_force_N")))
  eval ours_in(2, sprintf("%.1f ms", 1e3*(onset - number("run", "first_contact_s"))))
  eval ours_in(3, sprintf("%.2f ms", 1e3*(number("run", "peak_time_s") - onset)))
  eval label_curve(sprintf("%s:\nslipping\nstops at\n%.4f s", short_of(set), onset), onset, -270, "left offset 0.6,1")
}
set multiplot
plot [29.1:29.14] [-500:0] @each_set using "time_s":(@force) @layered

# Slip stops before the force is largest.
unset label; unset arrow; unset title; unset ylabel; unset grid
set lmargin at screen 0.17; set rmargin at screen 0.5; set bmargin at screen 0.23; set tmargin at screen 0.44
set xlabel "ms after slipping stops" offset 0,0.3
set xtics 0.4 format "%g"; set ytics -450,100
set arrow from 0,graph 0 to 0,graph 1 nohead linestyle event
plot [-0.4:0.8] [-480:-260] @each_set using (1e3*(column("time_s") - value(set."_onset"))):(@force) \
    @layered
