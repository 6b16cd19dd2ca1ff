# rho near the critical speed, with and without mass loss.
set title caption(17, "Displacement ρ of O near the critical speed", \
  "a: ".loss("a")."; b: ".loss("b")."; ".dotted("a"))
t_1 = number("a", "mass_loss_time")
stats data using (follow(of_run("a", "time_s"), of_run("a", "speed_Hz"), t_1)) nooutput
loss_Hz = crossing
paper_Hz = 11.8                                    # and when the run reaches it
stats data using (follow(of_run("a", "speed_Hz"), of_run("a", "time_s"), paper_Hz)) nooutput
paper_s = crossing
set xrange [1:4]
set yrange [0:3.3]
set xlabel "t, s"
set ylabel "ρ, mm"
mark_height = 0.7
eval mark_instant("t_1", t_1)
eval mark_critical("a")
set label "a" at 2.47,2.15
set label "b" at 2.33,0.8 right
set arrow from graph 0,first clearance_of("a") to graph 1,first clearance_of("a") nohead linestyle clearance
rho(name) = of_run(name, "rho_m")*1e3
stats data using (rho("a")) name "a" nooutput
stats data using (rho("b")) name "b" nooutput
set label sprintf("largest ρ: a %.2f mm, b %.2f mm: %s; paper: no contact", a_max, b_max, \
  contact("a", a_max > b_max ? a_max : b_max)) \
  at graph 0.97,0.82 right boxed front
set label sprintf("speed at the mass loss: %.1f Hz; paper: %g Hz, which is reached at %.2f s", loss_Hz, paper_Hz, \
  paper_s) \
  at graph 0.97,0.75 right boxed front
plot data using (of_run("a", "time_s")):(rho("a")) with lines linestyle ours notitle, \
     data using (of_run("b", "time_s")):(rho("b")) with lines linestyle ours dashtype (9, 5) notitle \
  @digitised
