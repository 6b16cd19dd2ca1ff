# F_n after a mass loss at a lower speed.
set title caption(13, "Radial force F_n, mass loss at t_1 = 14.15 s, f ≈ 75 Hz", \
  "μ = 0.3, k_t = 8×10^8 N/m, motor still driving")
set xrange [14.15:14.3]
set yrange [-160:0]
set xlabel "t, s"
set ylabel "F_n, kN"
set format x "%.2f"
stats data using "time_s":(column("normal_force_N")/1e3) name "F" nooutput
set arrow from graph 0,first -136 to graph 1,first -136 nohead linestyle published
set label beside("largest |F_n|", sprintf("%.1f kN at %.4f s", -F_min_y, F_pos_min_y), "136 kN") \
  at graph 0.03,0.4 boxed front
plot data using "time_s":(column("normal_force_N")/1e3) with lines linetype 1 notitle
