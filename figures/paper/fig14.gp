# rho after a mass loss far above the critical speed, with the clearance.
stats data using "time_s":(column("rho_m")*1e3) name "rho" nooutput
stats data using "speed_Hz" name "f" nooutput
# The printed digits of the clearance allow a far wider range than the margin by which the rotor stays clear;
# the draws of policy.md: (a) over the rounding of the loss's time, (b) over that of all inputs.
stats reference_data."/printed-inputs.csv" using (strcol("input") eq "clearance" ? 1e3*column("least") : NaN) name "least" nooutput
stats reference_data."/printed-inputs.csv" using (strcol("input") eq "clearance" ? 1e3*column("greatest") : NaN) name "greatest" nooutput
eval share_of("contacts_9", "a"); eval share_of("contacts_9", "b")
t_1 = number("run", "mass_loss_time")
stats data using (follow(column("time_s"), column("speed_Hz"), t_1)) nooutput
set title caption(14, "Displacement ρ of O, ".loss("run").sprintf(", f = %.1f Hz", crossing), \
  motor("run", f_max)."; ".dotted("run"))
set xrange [9:11]
set yrange [0:3.6]
set xlabel "t, s"
set ylabel "ρ, mm"
eval mark_instant("t_1", t_1)
set arrow from graph 0,first clearance_of("run") to graph 1,first clearance_of("run") nohead linestyle clearance
set object 1 rectangle from graph 0,first least_min to graph 1,first greatest_min fillcolor rgb "#ece5d5" fillstyle solid noborder behind
set label sprintf("shaded: clearances that print the same, %g to %g mm", least_min, greatest_min) at graph 0.97,first 3.25 right
set label beside("largest ρ", sprintf("%.3f mm at %.4f s: %s", rho_max_y, rho_pos_max_y, contact("run", rho_max_y)), \
  "no contact") at graph 0.97,0.62 right boxed front
set label sprintf("{/:Bold draws that stay clear}\nover the rounding of the loss's time: %.0f %%\nover that of all inputs: %.0f %%", \
  contacts_9_a_max, contacts_9_b_max) at graph 0.97,0.44 right boxed front
plot data using "time_s":(column("rho_m")*1e3) with lines linestyle ours notitle \
  @digitised
