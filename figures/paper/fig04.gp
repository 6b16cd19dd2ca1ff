# The rotation speed for high, intermediate and low friction.
set title caption(4, "Rotation speed f = q̇_3/2π of the rotor", \
  "mass loss at t_1 = 29.1 s; level: no contact, steep: impacts; grey: published method, whose friction chatters in rolling")
set xrange [29.1:29.35]
set yrange [0:160]
set xlabel "t, s"
set ylabel "f, Hz"
set format x "%.2f"
set key at graph 0.45,0.6
set arrow from graph 0,first 45 to graph 1,first 45 nohead linestyle published
set label "paper: 45 Hz as rolling sets in, μ = 0.3" at graph 0.985,first 45 right offset 0,0.7 \
  textcolor rgb grey boxed front
plot for [i = 1:3] fixed = "mu = ".word("0.3 0.2 0.08", i)." by rk4" \
  data using (of_run(fixed, "time_s")):(of_run(fixed, "speed_Hz")) \
  with lines linestyle fixed_steps linewidth 2.4 notitle, \
  for [i = 1:3] name = word("0.3 0.2 0.08", i) \
  data using (of_run("mu = ".name, "time_s")):(of_run("mu = ".name, "speed_Hz")) \
  with lines linetype i linewidth 1.2 title "μ = ".name
