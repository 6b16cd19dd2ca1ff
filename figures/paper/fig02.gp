# q1, q2 and rho while the rotor runs up through its critical speed.
set title caption(2, "Start-up: generalised coordinates and displacement of O", \
  sprintf("M_{mot} = %g N m, e_x = %g mm, critical speed %.1f Hz", number("run", "torque"), \
  1e3*number("run", "eccentricity"), critical_Hz("run")))
stats data using (follow(column("speed_Hz"), column("time_s"), critical_Hz("run"))) nooutput
set arrow from crossing,graph 0 to crossing,graph 1 nohead linestyle reading
set multiplot layout 3,1 margins 0.1,0.97,0.11,0.86 spacing 0,0.05
set xrange [0:6.5]
set format x ""
set ytics -1,0.5,0.5
stats data using "time_s":(column("rho_m")*1e3) name "rho" nooutput

set ylabel "q_1, mm"
set yrange [-1.5:0.75]
its_quantity = "q1_m"
plot data using "time_s":(column("q1_m")*1e3) with lines linestyle ours notitle @digitised
unset title
set ylabel "q_2, mm"
its_quantity = "q2_m"
plot data using "time_s":(column("q2_m")*1e3) with lines linestyle ours notitle @digitised
set ylabel "ρ, mm"
set xlabel "t, s" offset 0,0.4
set format x "%g"
set label sprintf("largest ρ = %.2f mm at %.2f s", rho_max_y, rho_pos_max_y) \
  at rho_pos_max_y, rho_max_y offset 2,-0.5
set ytics 0,0.5
set yrange [0:1.6]
its_quantity = "rho_m"
set label "critical speed" at crossing,graph 0.85 right offset -0.5,0 textcolor rgb grey front
plot data using "time_s":(column("rho_m")*1e3) with lines linestyle ours notitle @digitised
