# q1, q2 and rho while the rotor runs up through its critical speed.
set title caption(2, "Start-up: generalised coordinates and displacement of O", \
  sprintf("M_{mot} = %g N m, e_x = %g mm, critical speed %.1f Hz", number("run", "torque"), \
  1e3*number("run", "eccentricity"), number("run", "critical_speed_Hz")))
eval find_critical("run")
set arrow from crossing,graph 0 to crossing,graph 1 nohead linestyle event
set multiplot layout 3,1 margins 0.1,0.97,0.11,0.86 spacing 0,0.05
set format x ""
set ytics -1,0.5,0.5
curves = '@each_set using "time_s":(column(its_quantity)*1e3) @layered'

set ylabel "q_1, mm"
its_quantity = "q1_m"
plot [0:6.5] [-1.5:0.75] @curves
unset title
set ylabel "q_2, mm"
its_quantity = "q2_m"
plot [0:6.5] [-1.5:0.75] @curves
set ylabel "ρ, mm"
set xlabel "t, s" offset 0,0.4
set format x "%g"
set ytics 0,0.5
its_quantity = "rho_m"
set label "critical speed" at crossing,graph 0.85 right offset -0.5,0
do for [set in sets] {
  eval use(set)
  stats data using "time_s":(column("rho_m")*1e3) name "rho" nooutput
  eval label_curve(sprintf("%s: largest ρ = %.2f mm at %.2f s", short_of(set), rho_max_y, rho_pos_max_y), \
    rho_pos_max_y + 0.5, is_printed(set) ? 1.35 : 1.02, "left")
}
if (words(sets) == 2) { set label "the curves coincide, thin on wide" at rho_pos_max_y + 0.5,0.69 left boxed }
plot [0:6.5] [0:1.6] @curves
