# rho after a mass loss far above the critical speed, with the clearance.
# The printed digits of the clearance allow a far wider range than the margin by which the rotor stays clear;
# the draws of policy.md: (a) over the rounding of the loss's time, (b) over that of all inputs.
stats reference_data."/printed-inputs.csv" using (strcol("input") eq "clearance" ? 1e3*column("least") : NaN) name "least" nooutput
stats reference_data."/printed-inputs.csv" using (strcol("input") eq "clearance" ? 1e3*column("greatest") : NaN) name "greatest" nooutput
t_1 = number("run", "mass_loss_time")
stats data using "speed_Hz" name "f" nooutput
stats data using (follow(column("time_s"), column("speed_Hz"), t_1)) nooutput
set title caption(14, "Displacement ρ of O, ".loss("run").sprintf(", f = %.1f Hz", crossing), \
  motor("run", f_max)."; ".dotted("run"))
set xlabel "t, s"
set ylabel "ρ, mm"
eval mark_instant("t_1", t_1)
set arrow from graph 0,first clearance_of("run") to graph 1,first clearance_of("run") nohead linestyle clearance
set object 1 rectangle from graph 0,first least_min to graph 1,first greatest_min fillcolor rgb "#ece5d5" fillstyle solid noborder behind
set label sprintf("shaded: clearances that print the same, %g to %g mm", least_min, greatest_min) at graph 0.97,first 3.25 right
eval table(0.42, 0.66, 22)
eval row(1, "largest ρ", "no contact"); eval row(2, "draws of t_1 that stay clear", "")
eval row(3, "draws of all inputs that do", "")
do for [set in sets] {
  eval use(set)
  stats data using "time_s":(column("rho_m")*1e3) name "rho" nooutput
  eval share_of("contacts_9", "a"); eval share_of("contacts_9", "b")
  eval ours_in(1, sprintf("%.3f mm", rho_max_y))
  eval ours_in(2, sprintf("%.0f %%", contacts_9_a_max)); eval ours_in(3, sprintf("%.0f %%", contacts_9_b_max))
  eval label_curve(short_of(set), t_1, 0.75*rho_max_y, "right offset -1,0")
}
plot [9:11] [0:3.6] @each_set using "time_s":(column("rho_m")*1e3) @layered
