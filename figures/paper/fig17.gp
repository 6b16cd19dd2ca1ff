# rho near the critical speed, with and without mass loss.
set title caption(17, "Displacement ρ of O near the critical speed", \
  "a: mass loss at t_1 = 2.2 s; b: none; dotted: clearance r_a − r = 3 mm")
stats data using (column("time_s") == 2.2 ? of_run("a", "speed_Hz") : NaN) name "f" nooutput
set xrange [1:4]
set yrange [0:3.3]
set xlabel "t, s"
set ylabel "ρ, mm"
set key at graph 0.97,0.68
set arrow from graph 0,first 3 to graph 1,first 3 nohead linestyle clearance
rho(name) = of_run(name, "rho_m")*1e3
stats data using (rho("a")) name "a" nooutput
stats data using (rho("b")) name "b" nooutput
set label sprintf("largest ρ: a %.2f mm, b %.2f mm; paper: no contact", a_max, b_max) \
  at graph 0.97,0.82 right boxed front
set label sprintf("speed at the mass loss: %.1f Hz; paper: 11.8 Hz, which is passed at 2.23 s", f_max) \
  at graph 0.97,0.75 right boxed front
plot data using (of_run("a", "time_s")):(rho("a")) with lines linetype 2 title "a", \
     data using (of_run("b", "time_s")):(rho("b")) with lines linetype 1 linewidth 1.8 title "b"
