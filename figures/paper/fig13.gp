# rho after a mass loss at a lower speed, F_n below it in the paper's axes, and the shares of draws that roll.
set title caption(13, "Displacement ρ and radial force F_n, ".loss("run"), friction("run").", ".stiffness("run").", ".motor("run"). \
  sprintf("; f = %.1f Hz at t_1, paper: 75 Hz", number("run", "speed_at_mass_loss_Hz")))
set multiplot
panel(left, right, bottom, top) = sprintf("set lmargin at screen %g; set rmargin at screen %g; \
  set bmargin at screen %g; set tmargin at screen %g", left, right, bottom, top)
touches(unused) = number("run", "touch_downs") > 0
free_s = 14.228                                    # where labels of a set without contact hide nothing
eval panel(0.08, 0.79, 0.52, 0.87)
set xtics 14.15,0.03 format ""
set ylabel "ρ, mm"
set ytics 1
eval level(clearance_of("run"), clearance)
set label sprintf("clearance %g mm", clearance_of("run")) at graph 0.985,first clearance_of("run") right offset 0,-0.7
do for [set in sets] {
  eval use(set)
  eval label_curve(short_of(set).(touches(0) ? sprintf(": touches the ring at %.4f s", number("run", "first_contact_s")) : \
    sprintf(": no contact, largest ρ %.2f mm", 1e3*number("run", "peak_displacement_m"))), \
    touches(0) ? 14.152 : free_s, 3.95, "left")
}
plot [14.15:14.3] [0:4.4] @each_set using "time_s":(column("rho_m")*1e3) @layered

unset title; unset label; unset arrow
eval panel(0.08, 0.79, 0.1, 0.49)
set xlabel "t, s" offset 0,0.4
set format x "%.2f"
set ylabel "F_n, kN"
set ytics 50
eval level(-136, published).says("paper: 136 kN", 0.02, -136, "offset 0,0.7")
law_place = "graph 0.985,first %g right offset 0,-0.9"
do for [set in sets] {
  eval use(set)
  eval mark_law("run")
  eval label_curve(short_of(set).(touches(0) ? sprintf(": largest |F_n| %.1f kN", 1e-3*number("run", "peak_normal_force_N")) : \
    ": no force"), touches(0) ? number("run", "peak_time_s") : free_s, touches(0) ? -50 : -20, "left offset 1,0")
}
plot [14.15:14.3] [-180:0] @each_set using "time_s":(column("normal_force_N")/1e3) @layered

unset label; unset arrow; unset xlabel; unset ylabel; unset xtics; unset grid
eval panel(0.83, 0.94, 0.1, 0.76)
unset ytics
set y2range [0:100]; set y2tics 50 format "%g %%"
set label "draws that roll,\nof inputs that\nprint the same" at screen 0.94,screen 0.87 right
do for [i = 1:words(sets)] {
  equations = word(sets, i)
  stats reference_data."/ensembles.csv" using (share("rolls_75", "b")) name "draws" nooutput
  set object i rectangle from i - 0.35,0 to i + 0.35,draws_max fillcolor rgb tint_of(equations) fillstyle solid noborder
  set label sprintf("%.0f %%", draws_max) at i,draws_max center offset 0,0.6 textcolor rgb tint_of(equations)
  set label short_of(equations) at i,(draws_max > 50 ? 3 : draws_max + 8) left rotate by 90 \
    textcolor rgb (draws_max > 50 ? "#ffffff" : tint_of(equations)) front
}
plot [0.4:words(sets) + 0.6] [0:100] NaN notitle
