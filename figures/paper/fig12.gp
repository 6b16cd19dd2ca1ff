# F_n after a mass loss at a lower speed.
stats data using "time_s":(column("normal_force_N")/1e3) name "F" nooutput
stats data using "speed_Hz" name "driven" nooutput
stats data every ::0::0 using "speed_Hz" name "f" nooutput
set title caption(12, "Radial force F_n, ".loss("run"), \
  friction("run").", ".stiffness("run").", ".motor("run", driven_max))
set xrange [19.1:19.2]
set yrange [-280:0]
set xlabel "t, s"
set ylabel "F_n, kN"
set format x "%.2f"
set arrow from graph 0,first -237 to graph 1,first -237 nohead linestyle published
set label "dashed: paper 237 kN" at graph 0.03,first -237 offset 0,0.7 textcolor rgb grey
set label beside("speed at the mass loss", sprintf("%.1f Hz", f_max), "100 Hz") at graph 0.03,0.66 boxed front
set label beside("largest |F_n|", F_min_y < 0 ? sprintf("%.1f kN at %.4f s", -F_min_y, F_pos_min_y) : "no contact", "237 kN") \
  at graph 0.03,0.4 boxed front
eval mark_law("run")
plot data using "time_s":(column("normal_force_N")/1e3) with lines linestyle ours notitle \
  @digitised
