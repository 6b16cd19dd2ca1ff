# The rotation speed for high, intermediate and low friction.
set title caption(4, "Rotation speed f = q̇_3/2π of the rotor", \
  sprintf("%s; flat: flight, steep: impacts; pale: %s by the %s, which chatters in rolling", \
    loss("mu = 0.3"), short_of(equations), by_method("mu = 0.3 by rk4")))
runs = "'mu = 0.3' 'mu = 0.2' 'mu = 0.08'"
set xlabel "t, s"
set ylabel "f, Hz"
set format x "%.2f"
eval level(45, published).says("paper: 45 Hz at the onset of rolling, ".friction("mu = 0.3"), 0.985, 45, "right offset 0,0.7 boxed")
fixed_data = data; fixed_steps = steps
do for [set in sets] {
  eval use(set)
  do for [name in runs] {
    at_Hz = name eq "mu = 0.08" ? 100 : 78
    stats data using (follow(-of_run(name, "speed_Hz"), of_run(name, "time_s"), -at_Hz)) nooutput
    of_run_and_set = friction(name).", ".short_of(set)
    if (name eq "mu = 0.08") { eval label_curve(of_run_and_set, crossing, at_Hz, is_printed(set) ? "left offset 1,0.5" : "right offset -1,-0.5") }
    else {                                         # along the steep curves, between them
      set label of_run_and_set at crossing,at_Hz center rotate by 90 offset (name eq "mu = 0.3" && is_printed(set) ? -1.1 : 0.9),0 \
        font small textcolor rgb tint_of(set)
    }
  }
}
plot [29.1:29.35] [0:160] for [i = 1:3] fixed = word(runs, i)." by rk4" \
  fixed_data using (of_run(fixed, "time_s")):(of_run(fixed, "speed_Hz")) \
  with lines linestyle fixed_steps linewidth beneath notitle, \
  for [set in from_below] for [name in runs] data_of(set) \
  using (of_run(name, "time_s")):(of_run(name, "speed_Hz")) @layered
