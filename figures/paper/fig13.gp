# F_n after a mass loss at a lower speed; of a set of equations without contact rho, beside the clearance.
set multiplot layout words(sets),1 margins 0.08,0.97,0.1,0.83 spacing 0,0.11 \
  title caption(13, "Radial force F_n, without contact displacement ρ; ".loss("run"), \
  friction("run").", ".stiffness("run").", ".motor("run")."; draws: of inputs that print the same")
set xtics 14.15,0.03
do for [set in sets] {
  eval use(set)
  unset label; unset arrow
  touches = number("run", "touch_downs") > 0
  stats reference_data."/ensembles.csv" using (share("rolls_75", "b")) name "draws" nooutput
  set title sprintf("{/:Bold %s: %s}; of all draws %.0f %% roll", words_of(set), touches ? sprintf("largest |F_n| %.1f kN at %.4f s", \
    1e-3*number("run", "peak_normal_force_N"), number("run", "peak_time_s")) : "no contact", draws_max) \
    textcolor rgb tint_of(set) offset 0,-0.5
  set label sprintf("f = %.1f Hz, paper: 75 Hz", number("run", "speed_at_mass_loss_Hz")) at graph 0.02,0.9 left boxed front
  is_last = set eq word(sets, words(sets))
  set xlabel (is_last ? "t, s" : "") offset 0,0.4; set format x (is_last ? "%.2f" : "")
  if (touches) {
    set ylabel "F_n, kN"; set ytics 50
    eval level(-136, published).says("paper: 136 kN", 0.02, -136, "offset 0,0.7")
    eval mark_law("run")
    plot [14.15:14.3] [-180:0] data using "time_s":(column("normal_force_N")/1e3) with lines linestyle ours notitle
  } else {
    stats data using "time_s":(column("rho_m")*1e3) name "rho" nooutput
    set ylabel "ρ, mm"; set ytics 1
    eval level(clearance_of("run"), clearance)
    set label sprintf("clearance %g mm", clearance_of("run")) at graph 0.985,first clearance_of("run") right offset 0,0.7
    set label sprintf("largest ρ: %.2f mm", rho_max_y) at rho_pos_max_y,rho_max_y left offset 2,-0.2 boxed front
    plot [14.15:14.3] [0:4.4] data using "time_s":(column("rho_m")*1e3) with lines linestyle ours notitle
  }
}
