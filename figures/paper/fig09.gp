# The trajectory of O in the stator's frame, gravity downwards, in four intervals, one after the other.
eval "set terminal ".square
stats data using "time_s" name "window" nooutput
t_1 = number("event", "mass_loss_time")
array from[5] = [window_min, t_1 + 0.06, t_1 + 0.1, t_1 + 0.15, window_max]
# The mass loss, and an arrow in each interval.
array arrows[4]
eval place_at("event", t_1, 0)
set label 1 at y_1,x_1 point linestyle lost front
do for [i = 1:4] {
  eval place_at("event", i == 1 ? t_1 + 2e-3 : from[i + 1] - 1e-3, 1e-5)
  arrows[i] = sprintf("from %.9g,%.9g to %.9g,%.9g", y_1, x_1, y_2, x_2)
}
set multiplot title caption(9, "Trajectory of O in the stator's frame O_ax_ay_a", \
  friction("event").", ".loss("event")." (cross); grey: ".by_method("rk4")."; ".dotted("event"))
set size ratio -1
set xrange [-3.4:3.4]
set yrange [3.4:-3.4]
set xtics 2; set ytics 2
set object 1 circle at 0,0 size clearance_of("event") fillstyle empty border linecolor rgb black linewidth 1.2 dashtype (1,5)
unset key
in_panel(name, c) = column("time_s") >= from[i] && column("time_s") <= from[i + 1] ? 1e3*of_run(name, c) : NaN
do for [i = 1:4] {
  at_left = i % 2; at_bottom = i > 2
  set lmargin at screen at_left ? 0.11 : 0.57; set rmargin at screen at_left ? 0.5 : 0.96
  set bmargin at screen at_bottom ? 0.08 : 0.51; set tmargin at screen at_bottom ? 0.45 : 0.88
  set title sprintf("%.2f–%.2f s", from[i], from[i + 1]) offset 0,-0.5
  set xlabel (at_bottom ? "y_a, mm" : "") offset 0,0.3; set format x (at_bottom ? "%g" : "")
  set ylabel (at_left ? "x_a (down), mm" : "")
  eval "set arrow 1 ".arrows[i]." arrowstyle 5 front"
  plot data using (in_panel("rk4", "y_a_m")):(in_panel("rk4", "x_a_m")) with lines linestyle fixed_steps, \
    data using (in_panel("event", "y_a_m")):(in_panel("event", "x_a_m")) with lines linestyle ours linewidth 1 @digitised
  unset label 1
}
unset multiplot
