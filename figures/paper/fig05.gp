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
set label sprintf("slipping stops at %.4f s", rolling_min) at rolling_min,-480 right offset -1,0 \
  textcolor rgb grey boxed front
set label beside("largest |F_n|", sprintf("%.1f kN at %.4f s", -F_min_y, F_pos_min_y), "455 kN") \
  at graph 0.03,0.78 boxed front
set label beside("onset of rolling", sprintf("%.4f s after the first contact", rolling_min - contact_min), \
  "0.023 s after the first collision") at graph 0.03,0.6 boxed front
set multiplot
plot data using "time_s":(column("normal_force_N")/1e3) with lines linestyle ours notitle \
  @digitised

# Slip stops before the force is largest.
unset label; unset arrow; unset title; unset ylabel; unset grid
set lmargin at screen 0.17; set rmargin at screen 0.5; set bmargin at screen 0.23; set tmargin at screen 0.44
set xrange [-0.4:0.8]; set xlabel "ms after slipping stops" offset 0,0.8
set yrange [-480:-260]
set xtics 0.4 format "%g"; set ytics -450,100
set arrow from 0,graph 0 to 0,graph 1 nohead linestyle reading
set label sprintf("largest %.2f ms after slip stops", 1e3*(F_pos_min_y - rolling_min)) at graph 0.97,0.85 right boxed textcolor rgb grey
plot data using (1e3*(column("time_s") - rolling_min)):(column("normal_force_N")/1e3) with lines linestyle ours notitle
