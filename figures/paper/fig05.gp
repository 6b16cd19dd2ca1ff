# F_n from separate collisions to continuous contact.
set title caption(5, "Impact force F_n from separate collisions to continuous contact", \
  friction("run").", ".loss("run"))
set xlabel "t, s"
set ylabel "F_n, kN"
set format x "%.3f"
stats data using "time_s":(column("normal_force_N")/1e3) name "F" nooutput
stats data using (column("contact_state") == 2 ? column("time_s") : NaN) name "rolling" nooutput
stats data using (column("contact_state") > 0 ? column("time_s") : NaN) name "contact" nooutput
set xrange [29.1:29.14]
set yrange [-500:0]
set arrow from rolling_min,graph 0 to rolling_min,graph 1 nohead linestyle reading
set label sprintf("slipping stops at %.4f s", rolling_min) at rolling_min,-465 right offset -1,0 \
  textcolor rgb grey boxed front
set label beside("largest |F_n|", sprintf("%.1f kN at %.4f s", -F_min_y, F_pos_min_y), "455 kN") \
  at graph 0.05,0.35 boxed front
set label beside("onset of rolling", sprintf("%.4f s after the first contact", rolling_min - contact_min), \
  "0.023 s after the first collision") at graph 0.05,0.6 boxed front
plot data using "time_s":(column("normal_force_N")/1e3) with lines linetype 1 notitle \
  @digitised
