# q1 and rho as fast rolling sets in, one set of equations above the other.
set multiplot layout words(sets),1 margins 0.07,0.97,0.1,0.83 spacing 0,0.1 \
  title caption(7, "Generalised coordinate q_1 in the rotating axes, and displacement ρ", \
  friction("run").", ".loss("run")."; the axes turn at f, and O the other way at the whirl frequency: q_1 has their sum")
set ylabel "mm"
set ytics 2
mark_height = 0.06
# The frequency of q1 from its zero crossings over the first 5 ms of rolling.
cross(t, q) = (t > onset && t < onset + 5e-3 && q0 < 0 && q >= 0 ? \
  (crossings = crossings + 1, last = t0 - q0*(t - t0)/(q - q0), first = crossings == 1 ? last : first) : 0, \
  t0 = t, q0 = q, 0)
early(c) = column("time_s") < 29.125 ? 1e3*column(c) : NaN
do for [set in sets] {
  eval use(set)
  unset label; unset arrow
  onset = number("run", "rolling_onset_s"); t0 = NaN; q0 = NaN; crossings = 0
  stats data using (cross(column("time_s"), column("q1_m"))) nooutput
  f_q = (crossings - 1)/(last - first); f = number("run", "rolling_onset_speed_Hz")
  set title sprintf("{/:Bold %s}: q_1 has %.1f Hz in %d periods, less f = %.1f Hz at the onset: %.1f Hz; {/:Normal paper: about 770 Hz}", \
    words_of(set), f_q, crossings - 1, f, f_q - f) \
    textcolor rgb tint_of(set) offset 0,-0.5
  eval mark_instant(sprintf("rolling from %.4f s", onset), onset)
  eval level(3.5, published).says("paper: ρ ≈ 3.5 mm", 0.985, 3.5, "right offset 0,0.7 boxed")
  # Labels where each extends furthest in the first sixth.
  stats data using "time_s":(early("q1_m")) name "q" nooutput
  stats data using "time_s":(early("rho_m")) name "rho" nooutput
  set label "q_1" at q_pos_min_y,q_min_y center offset 0,-0.8
  set label "ρ" at rho_pos_max_y,rho_max_y center offset 0,0.9
  is_last = set eq word(sets, words(sets))
  set xlabel (is_last ? "t, s" : "") offset 0,0.4; set format x (is_last ? "%.3f" : "")
  plot [29.12:29.15] [-5.2:5] data using "time_s":(column("q1_m")*1e3) with lines linestyle ours notitle, \
       data using "time_s":(column("rho_m")*1e3) with lines linestyle ours linewidth 2.2 notitle
}
