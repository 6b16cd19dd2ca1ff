# rho after a mass loss far above the critical speed, with the clearance.
# The printed digits of the clearance allow a far wider range than the margin by which the rotor stays clear;
# the draws of policy.md: (a) over the rounding of the loss's time, (b) over that of all inputs.
stats reference_data."/printed-inputs.csv" using (strcol("input") eq "clearance" ? 1e3*column("least") : NaN) name "least" nooutput
stats reference_data."/printed-inputs.csv" using (strcol("input") eq "clearance" ? 1e3*column("greatest") : NaN) name "greatest" nooutput
t_1 = number("run", "mass_loss_time")
set title caption(14, "Displacement ρ of O, ".loss("run").sprintf(", f = %.1f Hz", number("run", "speed_at_mass_loss_Hz")), \
  motor("run")."; ".dotted("run"))
set xlabel "t, s"
set ylabel "ρ, mm"
eval mark_instant("t_1", t_1)
eval level(clearance_of("run"), clearance)
set object 1 rectangle from graph 0,first least_min to graph 1,first greatest_min fillcolor rgb "#ece5d5" fillstyle solid noborder behind
set label sprintf("shaded: clearances that print the same, %g to %g mm", least_min, greatest_min) at graph 0.97,first 3.25 right
eval table(0.42, 0.66, 22)
eval row(1, "largest ρ", "no contact"); eval row(2, "draws of t_1 that stay clear", "")
eval row(3, "draws of all inputs that do", "")
do for [set in sets] {
  eval use(set)
  largest = 1e3*number("run", "peak_displacement_m")
  stats reference_data."/ensembles.csv" using (share("contacts_9", "a")) name "of_t_1" nooutput
  stats reference_data."/ensembles.csv" using (share("contacts_9", "b")) name "of_all" nooutput
  eval ours_in(1, sprintf("%.3f mm", largest))
  eval ours_in(2, sprintf("%.0f %%", of_t_1_max)); eval ours_in(3, sprintf("%.0f %%", of_all_max))
  eval label_curve(short_of(set), t_1, 0.75*largest, "right offset -1,0")
}
plot [9:11] [0:3.6] @each_set using "time_s":(column("rho_m")*1e3) @layered
