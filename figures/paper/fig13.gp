# F_n after a mass loss at a lower speed.
stats data using "time_s":(column("normal_force_N")/1e3) name "F" nooutput
stats data using "speed_Hz" name "driven" nooutput
stats data every ::0::0 using "speed_Hz" name "f" nooutput
set title caption(13, "Radial force F_n, ".loss("run"), \
  friction("run").", ".stiffness("run").", ".motor("run", driven_max))
set xrange [14.15:14.3]
set yrange [-160:0]
set xtics 14.15,0.03
set xlabel "t, s"
set ylabel "F_n, kN"
set format x "%.2f"
set arrow from graph 0,first -136 to graph 1,first -136 nohead linestyle published
set label "dashed: paper 136 kN" at graph 0.03,first -136 offset 0,0.7 textcolor rgb grey
set label beside("speed at the mass loss", sprintf("%.1f Hz", f_max), "75 Hz") at graph 0.03,0.66 boxed front
set label beside("largest |F_n|", F_min_y < 0 ? sprintf("%.1f kN at %.4f s", -F_min_y, F_pos_min_y) : "no contact", "136 kN") \
  at graph 0.03,0.4 boxed front
eval mark_law("run", "graph 0.97,0.05 right")
plot data using "time_s":(column("normal_force_N")/1e3) with lines linetype 1 notitle \
  @digitised
