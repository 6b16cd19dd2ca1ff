# F_n after a mass loss at a lower speed.
set title caption(12, "Radial force F_n, ".loss("run"), friction("run").", ".stiffness("run").", ".motor("run"))
set xlabel "t, s"
set ylabel "F_n, kN"
set format x "%.2f"
law_place = "graph 0.985,first %g right offset 0,-0.9"
eval level(-237, published).says("paper: 237 kN", 0.02, -237, "offset 0,0.7")
eval table(0.02, 0.55, 8)
eval row(1, "f at t_1", "100 Hz"); eval row(2, "largest |F_n|", "237 kN"); eval row(3, "reached at", "")
do for [set in sets] {
  eval use(set)
  t_F = number("run", "peak_time_s")
  eval ours_in(1, sprintf("%.1f Hz", number("run", "speed_at_mass_loss_Hz")))
  eval ours_in(2, sprintf("%.1f kN", 1e-3*number("run", "peak_normal_force_N"))); eval ours_in(3, sprintf("%.4f s", t_F))
  eval mark_law("run")
  eval label_curve(short_of(set), t_F, -150, is_printed(set) ? "left offset 1,0" : "right offset -3,0")
}
plot [19.1:19.2] [-280:0] @each_set using "time_s":(column("normal_force_N")/1e3) @layered
