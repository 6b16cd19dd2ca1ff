# The trajectory of O in the interval of Fig. 15.
run = "run"
load figures."/paper/trajectory.gp"
half_s = 0.5/number(run, "critical_speed_Hz")      # of its vibration: O swings out in each
swings = 3
set multiplot layout 1,words(sets) margins 0.08,0.98,0.12,0.84 spacing 0.08,0 \
  title caption(16, subject, sprintf("%g–%g s, ", window_min, window_max).loss(run)."; ".dotted(run).sprintf("; 1–%d: its first swings, one in each %.2f s", swings, half_s))
do for [set in sets] {
  eval use(set)
  eval begin_panel("0.5,1.6")
  eval show_sense(t_1 + 8e-3, 1e-5)
  eval show_sense(window_max - 0.05, 1e-5)
  do for [n = 1:swings] {
    stats data using (int((column("time_s") - t_1)/half_s) == n - 1 && column("time_s") > t_1 ? column("time_s") : NaN): \
      (sqrt(column("x_a_m")**2 + column("y_a_m")**2)) name "swing" nooutput
    eval place("x_1", "y_1", swing_pos_max_y)
    placed = ""; eval beside(y_1, x_1, n, 0.25)
  }
  plot @orbit
}
