# The trajectory of O at high friction, until it rolls.
run = "run"
load figures."/paper/trajectory.gp"
set multiplot layout 1,words(sets) margins 0.08,0.98,0.12,0.84 spacing 0.08,0 \
  title caption(8, subject, friction(run).", ".loss(run)."; until 7 ms after the onset of rolling; ".dotted(run))
do for [set in sets] {
  eval use(set)
  end = number(run, "rolling_onset_s") + 7e-3
  eval begin_panel("0.8,0.4")
  eval show_sense(t_1 + 2e-3, 1e-5)
  eval show_sense(end - 2e-4, 1e-6)
  plot @orbit
}
