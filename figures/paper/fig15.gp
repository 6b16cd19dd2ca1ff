# The beginning of Fig. 14.
t_1 = number("run", "mass_loss_time")
set title caption(15, "Displacement ρ of O, beginning of Fig. 14: ".loss("run").sprintf(", f = %.1f Hz", \
  number("run", "speed_at_mass_loss_Hz")), motor("run")."; ".dotted("run"))
set xlabel "t, s"
set ylabel "ρ, mm"
eval mark_instant("t_1", t_1)
eval level(clearance_of("run"), clearance)
eval table(0.55, 0.86, 10)
eval row(1, "largest ρ", "no contact"); eval row(2, "reached at", "")
do for [set in sets] {
  eval use(set)
  stats data using "time_s":(column("rho_m")*1e3) name "rho" nooutput
  eval ours_in(1, sprintf("%.3f mm", rho_max_y)); eval ours_in(2, sprintf("%.4f s", rho_pos_max_y))
  eval label_curve(short_of(set), t_1, 0.9*rho_max_y, "right offset -1,0")
}
plot [9.3:9.8] [0:3.3] @each_set using "time_s":(column("rho_m")*1e3) @layered
