# The rotation speed for high, intermediate and low friction.
set title caption(4, "Rotation speed f = q̇_3/2π of the rotor", \
  sprintf("%s; flat: flight, steep: impacts; wide grey: %s, whose friction chatters in rolling", \
    loss("mu = 0.3"), by_method("mu = 0.3 by rk4")))
runs = "'mu = 0.3' 'mu = 0.2' 'mu = 0.08'"
array tint[3] = [1, 2, 4]                          # green is too near the grey beneath it
set xrange [29.1:29.35]
set yrange [0:160]
set xlabel "t, s"
set ylabel "f, Hz"
set format x "%.2f"
set key at graph 0.45,0.6
set arrow from graph 0,first 45 to graph 1,first 45 nohead linestyle published
set label "paper: 45 Hz at the onset of rolling, ".friction("mu = 0.3") at graph 0.985,first 45 right offset 0,0.7 \
  textcolor rgb grey boxed front
plot for [i = 1:3] fixed = word(runs, i)." by rk4" \
  data using (of_run(fixed, "time_s")):(of_run(fixed, "speed_Hz")) \
  with lines linestyle fixed_steps linewidth beneath notitle, \
  for [i = 1:3] name = word(runs, i) \
  data using (of_run(name, "time_s")):(of_run(name, "speed_Hz")) \
  with lines linetype tint[i] linewidth 1.2 title friction(name) \
  @digitised
