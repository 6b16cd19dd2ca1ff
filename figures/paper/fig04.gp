# The rotation speed for high, intermediate and low friction.
set title caption(4, "Rotation speed f = q̇_3/2π of the rotor", \
  sprintf("%s; flat: flight, steep: impacts; wide grey: %s, whose friction chatters in rolling", \
    loss("mu = 0.3"), by_method("mu = 0.3 by rk4")))
runs = "'mu = 0.3' 'mu = 0.2' 'mu = 0.08'"
set xrange [29.1:29.35]
set yrange [0:160]
set xlabel "t, s"
set ylabel "f, Hz"
set format x "%.2f"
eval label_where("mu = 0.3", "speed_Hz", -1, 100, "right offset -1,0")
eval label_where("mu = 0.2", "speed_Hz", -1, 100, "left offset 1,0")
eval label_where("mu = 0.08", "speed_Hz", -1, 100, "left offset 1.5,0.5")
set arrow from graph 0,first 45 to graph 1,first 45 nohead linestyle published
set label "paper: 45 Hz at the onset of rolling, ".friction("mu = 0.3") at graph 0.985,first 45 right offset 0,0.7 \
  textcolor rgb grey boxed front
plot for [i = 1:3] fixed = word(runs, i)." by rk4" \
  data using (of_run(fixed, "time_s")):(of_run(fixed, "speed_Hz")) \
  with lines linestyle fixed_steps linewidth beneath notitle, \
  for [i = 1:3] name = word(runs, i) \
  data using (of_run(name, "time_s")):(of_run(name, "speed_Hz")) \
  with lines linestyle ours notitle \
  @digitised
