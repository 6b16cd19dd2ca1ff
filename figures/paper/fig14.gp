# rho after a mass loss far above the critical speed, with the clearance.
stats data using "time_s":(column("rho_m")*1e3) name "rho" nooutput
stats data using "speed_Hz" name "f" nooutput
# The printed digits of the clearance allow a far wider range than the margin by which the rotor stays clear.
stats printed_inputs using (strcol("input") eq "clearance" ? 1e3*column("least") : NaN) name "least" nooutput
stats printed_inputs using (strcol("input") eq "clearance" ? 1e3*column("greatest") : NaN) name "greatest" nooutput
t_1 = number("run", "mass_loss_time")
stats data using (follow(column("time_s"), column("speed_Hz"), t_1)) nooutput
set title caption(14, "Displacement ρ of O, ".loss("run").sprintf(", f = %.1f Hz", crossing), \
  motor("run", f_max)."; ".dotted("run"))
set xrange [9:11]
set yrange [0:3.3]
set xlabel "t, s"
set ylabel "ρ, mm"
set arrow from graph 0,first clearance_of("run") to graph 1,first clearance_of("run") nohead linestyle clearance
set label beside("largest ρ", sprintf("%.3f mm at %.4f s: %s", rho_max_y, rho_pos_max_y, contact("run", rho_max_y)), \
  "no contact") at graph 0.97,0.75 right boxed front
set object 1 rectangle from graph 0,first least_min to graph 1,graph 1 fillcolor rgb "#ece5d5" fillstyle solid noborder behind
set label sprintf("shaded: clearances that print the same, %g to %g mm", least_min, greatest_min) at graph 0.97,first least_min right offset 0,0.8
plot data using "time_s":(column("rho_m")*1e3) with lines linetype 1 notitle \
  @digitised
