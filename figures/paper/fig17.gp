# rho near the critical speed, with and without mass loss.
set title caption(17, "Displacement ρ of O near the critical speed", \
  "Graph a: ".loss("a")."; Graph b, dashed: ".loss("b").(words(sets) == 2 ? ", both coincide; " : "; ").dotted("a"))
t_1 = number("a", "mass_loss_time")
paper_Hz = 11.8                                    # and when the run reaches it
set xlabel "t, s"
set ylabel "ρ, mm"
mark_height = 0.7
eval mark_instant("t_1", t_1)
eval find_critical("a")
eval mark_instant("critical speed", crossing)
eval level(clearance_of("a"), clearance)
rho(name) = of_run(name, "rho_m")*1e3
eval table(0.51, 0.86, 14)
eval row(1, "f at t_1", sprintf("%g Hz", paper_Hz)); eval row(2, sprintf("%g Hz reached at", paper_Hz), "")
eval row(3, "largest ρ, a", "no contact"); eval row(4, "largest ρ, b", "no contact")
do for [set in sets] {
  eval use(set)
  eval ours_in(1, sprintf("%.1f Hz", number("a", "speed_at_mass_loss_Hz")))
  stats data using (follow(of_run("a", "speed_Hz"), of_run("a", "time_s"), paper_Hz)) nooutput
  eval ours_in(2, sprintf("%.2f s", crossing))
  stats data using (of_run("a", "time_s")):(rho("a")) name "a" nooutput
  eval ours_in(3, sprintf("%.2f mm", a_max_y)); eval ours_in(4, sprintf("%.2f mm", 1e3*number("b", "peak_displacement_before_loss_m")))
  eval label_curve(short_of(set), is_printed(set) ? a_pos_max_y : t_1, is_printed(set) ? a_max_y : 1.75, \
    is_printed(set) ? "center offset 0.2,0.7" : "right offset -0.5,0")
}
set label "{/:Italic a}" at 3.2,0.72 center offset 0,1.1
set label "{/:Italic b}" at 2.42,0.45 right offset -0.6,0
plot [1:4] [0:3.3] @each_set using (of_run("a", "time_s")):(rho("a")) @layered, \
     @each_set using (of_run("b", "time_s")):(rho("b")) with lines linestyle layer(set) dashtype (9, 5) notitle
