# The trajectory of O at high friction, in the paper's interval.
run = "run"
load figures."/paper/trajectory.gp"
set multiplot layout 1,words(sets) margins 0.08,0.98,0.12,0.84 spacing 0.08,0 \
  title caption(8, subject, sprintf("%s, %.2f–%.2f s, %s; %s; O leaves it at 1, 2, …", friction(run), window_min, window_max, loss(run), dotted(run)))
do for [set in sets] {
  eval use(set)
  eval begin_panel("0.8,0.4")
  onset_s = number(run, "rolling_onset_s")
  if (onset_s != onset_s) { set label sprintf("at %.2f s it does not roll yet", window_max) at graph 0.04,0.05 }
  eval show_sense(t_1 + 2e-3, 1e-5)
  eval show_sense(window_max - 2e-4, 1e-6)
  eval number_exits(window_min, window_max)
  plot @orbit
}
