# The beginning of Fig. 14.
stats data using "time_s":(column("rho_m")*1e3) name "rho" nooutput
stats data using "speed_Hz" name "f" nooutput
t_1 = number("run", "mass_loss_time")
stats data using (follow(column("time_s"), column("speed_Hz"), t_1)) nooutput
set title caption(15, "Displacement ρ of O, beginning of Fig. 14: ".loss("run").sprintf(", f = %.1f Hz", crossing), \
  motor("run", f_max)."; ".dotted("run"))
set xrange [9.3:9.8]
set yrange [0:3.3]
set xlabel "t, s"
set ylabel "ρ, mm"
eval mark_instant("t_1", t_1)
set arrow from graph 0,first clearance_of("run") to graph 1,first clearance_of("run") nohead linestyle clearance
set label beside("largest ρ", sprintf("%.3f mm at %.4f s: %s", rho_max_y, rho_pos_max_y, contact("run", rho_max_y)), \
  "no contact") at graph 0.97,0.75 right boxed front
plot data using "time_s":(column("rho_m")*1e3) with lines linestyle ours notitle \
  @digitised
