# The beginning of Fig. 14.
set title caption(15, "Displacement ρ of O, beginning of Fig. 14: mass loss at t_1 = 9.4 s, f = 49.8 Hz", \
  "motor still driving; dotted: clearance r_a − r = 3 mm")
set xrange [9.3:9.8]
set yrange [0:3.3]
set xlabel "t, s"
set ylabel "ρ, mm"
stats data using "time_s":(column("rho_m")*1e3) name "rho" nooutput
set arrow from graph 0,first 3 to graph 1,first 3 nohead linestyle clearance
set label beside("largest ρ", sprintf("%.3f mm at %.4f s: no contact", rho_max_y, rho_pos_max_y), \
  "no contact") at graph 0.97,0.75 right boxed front
plot data using "time_s":(column("rho_m")*1e3) with lines linetype 1 notitle
