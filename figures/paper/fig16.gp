# The trajectory of O in the interval of Fig. 15.
run = "run"
load figures."/paper/trajectory.gp"
set multiplot layout 1,words(sets) margins 0.08,0.98,0.12,0.84 spacing 0.08,0 \
  title caption(16, subject, sprintf("%g–%g s, ", window_min, window_max).loss(run)."; ".dotted(run))
do for [set in sets] {
  eval use(set)
  eval begin_panel("0.5,1.6")
  eval show_sense(t_1 + 8e-3, 1e-5)
  eval show_sense(window_max - 0.05, 1e-5)
  plot @orbit
}
