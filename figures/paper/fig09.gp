# The trajectory of O at low friction in four intervals, one after the other; one set of equations above the other.
run = "event"
load figures."/paper/trajectory.gp"
array from[5] = [window_min, t_1 + 0.06, t_1 + 0.1, t_1 + 0.15, window_max]
set multiplot layout words(sets),4 margins 0.08,0.98,0.12,0.83 spacing 0.02,0.08 \
  title caption(9, subject, friction(run).", ".loss(run)." (cross); pale: ".by_method("rk4")."; ".dotted(run)."; O leaves it at 1, 2, …")
set xtics 2; set ytics 2
in_panel(name, c) = column("time_s") >= from[i] && column("time_s") <= from[i + 1] ? 1e3*of_run(name, c) : NaN
do for [set in sets] {
  eval use(set)
  is_last = set eq word(sets, words(sets))
  set xlabel (is_last ? "y_a, mm" : "") offset 0,0.3; set format x (is_last ? "%g" : "")
  do for [i = 1:4] {
    unset label; unset arrow
    # The mass loss, and an arrow in each interval.
    if (i == 1) { eval place("x_1", "y_1", t_1); set label at y_1,x_1 point linestyle lost front }
    eval show_sense(i == 1 ? t_1 + 2e-3 : from[i + 1] - 1e-3, 1e-5)
    set title sprintf(i == 1 ? "{/:Bold %s}, %.2f–%.2f s" : "%.0s%.2f–%.2f s", short_of(set), from[i], from[i + 1]) \
      textcolor rgb tint_of(set) offset 0,-0.5
    set ylabel (i == 1 ? "x_a (down), mm" : ""); set format y (i == 1 ? "%g" : "")
    eval number_exits(from[i], from[i + 1])
    plot [-4:4] [4:-4] data using (in_panel("rk4", "y_a_m")):(in_panel("rk4", "x_a_m")) with lines linestyle steps notitle, \
      data using (in_panel(run, "y_a_m")):(in_panel(run, "x_a_m")) with lines linestyle ours linewidth 1 notitle
  }
}
