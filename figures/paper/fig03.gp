# F_n for high, intermediate and low friction.
set title caption(3, "Radial component F_n of the impact force", \
  sprintf("%s, f_{max} = %g Hz, %s; pale: %s by the %s, steps of %g μs", loss("mu = 0.3"), \
    number("mu = 0.3", "motor_off_Hz"), stiffness("mu = 0.3"), short_of(equations), by_method("mu = 0.3 by rk4"), \
    1e6*number("mu = 0.3 by rk4", "step_rub")))
fixed_data = data; fixed_steps = steps
law_place = "first 29.158,first %g left offset 0,-0.5"
runs = "'mu = 0.3' 'mu = 0.2' 'mu = 0.08'"
load figures."/paper/forces.gp"
do for [i = 1:3] {
  @begin_panel
  set label "{/:Bold ".friction(name)."}" at graph (i < 3 ? 0.5 : 0.985),0.84 right
  if (i == 1) { eval level(-455, published).says("paper: 400–450 kN in rolling, largest 455 kN", 0.985, -455, "right offset 0,0.7 boxed") }
  do for [set in sets] {
    eval use(set)
    eval mark_law(name)
    eval label_curve(sprintf("%s: largest %.1f kN", short_of(set), kN(name)), is_printed(set) || words(sets) == 1 ? 29.158 : 29.238, -640, "left")
    if (i < 3) {
      stats data using (follow(-force(name), of_run(name, "time_s"), 100)) nooutput
      eval label_curve(short_of(set), crossing, -280, is_printed(set) == (i == 1) ? "right offset -1,0" : "left offset 1.5,0")
    } else { eval label_curve(short_of(set), is_printed(set) ? 29.27 : 29.127, -90, "left") }
  }
  fixed = name." by rk4"
  plot [29.1:29.35] [-720:0] fixed_data using (of_run(fixed, "time_s")):(force(fixed)) \
  with lines linestyle fixed_steps linewidth beneath notitle, @force_curves
}
