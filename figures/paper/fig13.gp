# F_n after a mass loss at a lower speed; without contact rho, which shows how far the rotor stays clear.
stats data using "time_s":(column("normal_force_N")/1e3) name "F" nooutput
stats data using "speed_Hz" name "driven" nooutput
stats data every ::0::0 using "speed_Hz" name "f" nooutput
set title caption(13, "Radial force F_n, ".loss("run"), \
  friction("run").", ".stiffness("run").", ".motor("run", driven_max))
set xrange [14.15:14.3]
set xtics 14.15,0.03
set xlabel "t, s"
set format x "%.2f"
set label 1 beside("speed at the mass loss", sprintf("%.1f Hz", f_max), "75 Hz") at graph 0.03,0.66 boxed front
set label 2 beside("largest |F_n|", F_min_y < 0 ? sprintf("%.1f kN at %.4f s", -F_min_y, F_pos_min_y) : "no contact", "136 kN") \
  at graph 0.03,0.4 boxed front
if (F_min_y < 0) {
  set ylabel "F_n, kN"
  set yrange [-160:0]
  set arrow from graph 0,first -136 to graph 1,first -136 nohead linestyle published
  set label "dashed: paper 136 kN" at graph 0.03,first -136 offset 0,0.7 textcolor rgb grey
  eval mark_law("run")
  plot data using "time_s":(column("normal_force_N")/1e3) with lines linestyle ours notitle \
    @digitised
} else {
  eval share_of("rolls_75", "b")
  stats data using "time_s":(column("rho_m")*1e3) name "rho" nooutput
  set title caption(13, sprintf("No contact, so no force: displacement ρ of O, %s", loss("run")), \
    friction("run").", ".motor("run", driven_max)."; ".dotted("run"))
  set ylabel "ρ, mm"
  set yrange [0:4.6]
  set label 1 at graph 0.03,first 4.25 left
  set label 2 at graph 0.27,first 4.25 left
  set label 3 sprintf("{/:Bold no contact}\nρ reaches %.2f mm\nof all draws of inputs that print the same, %.0f %% roll", \
    rho_max_y, rolls_75_b_max) at graph 0.46,first 4.25 left front
  set arrow from graph 0,first clearance_of("run") to graph 1,first clearance_of("run") nohead linestyle clearance
  plot data using "time_s":(column("rho_m")*1e3) with lines linestyle ours notitle \
    @digitised
}
