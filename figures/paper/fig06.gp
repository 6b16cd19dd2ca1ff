# The kinetic energy while the rub develops, with the energies that the text states.
set title caption(6, "Kinetic energy T of the rotor", friction("run").", ".loss("run")."; by our choice, the 6th contact parts collisions from sliding")
set xlabel "t, s"
set ylabel "T, J"
set format x "%.3f"
T = "kinetic_energy_J"
# The text's energies count continuous contact from the sixth touch-down.
watch(t, state) = (state > 0 && !touching ? (touch_downs = touch_downs + 1, \
  continuous = touch_downs == 6 ? t : continuous) : 0, touching = state > 0, 0)
do for [paper in "4000 3000 1050"] {
  eval level(real(paper), published).says("paper: ".(paper eq "3000" ? "4000 − 1000" : paper)." J", \
    paper eq "1050" ? 0.99 : 0.01, real(paper), paper eq "1050" ? "right offset 0,-1" : "offset 0,0.7")
}
eval table(0.02, 0.64, 20)                         # its rows are between the lines
eval row(1, "at the mass loss", "4000 J"); eval row(2, "after it", "")
eval row(3, "lost in collisions", "1000 J"); eval row(4, "lost in sliding", "1950 J")
eval row(5, "left at the onset of rolling", "1050 J"); eval row(6, "left at the largest force", "")
set style arrow 1 heads size screen 0.006,90 linewidth 1
gap = 4e-4                                         # s, of the brackets from the vertical lines
t_1 = number("run", "mass_loss_time")
do for [set in sets] {
  eval use(set)
  onset = number("run", "rolling_onset_s"); touch_downs = 0; touching = 0; continuous = NaN
  stats data using (watch(column("time_s"), column("contact_state"))) nooutput
  stats data using (column("time_s") == onset ? column(T) : NaN) name "left" nooutput
  stats data using (column("time_s") == number("run", "peak_time_s") ? column(T) : NaN) name "pressed" nooutput
  stats data using (column("time_s") == continuous ? column(T) : NaN) name "ahead" nooutput
  stats data using T name "all" nooutput
  stats data using (column("time_s") == t_1 ? column(T) : NaN) name "separated" nooutput
  T0 = all_max; T1_0 = separated_min; T1 = ahead_min; T2 = left_min
  eval ours_in(1, sprintf("%.0f J", T0)); eval ours_in(2, sprintf("%.0f J", T1_0))
  eval ours_in(3, sprintf("%.0f J", T1_0 - T1)); eval ours_in(4, sprintf("%.0f J", T1 - T2))
  eval ours_in(5, sprintf("%.0f J", T2)); eval ours_in(6, sprintf("%.0f J", pressed_min))
  do for [at in "continuous onset"] {
    set arrow from value(at),graph 0 to value(at),graph 1 nohead linestyle event
    set label (at eq "onset" ? "rolls" : "6th contact") at value(at),graph 0.03 left rotate by 90 offset -0.6,0 \
      textcolor rgb tint_of(set) font small
  }
  # Brackets from one energy to another.
  set arrow from continuous - gap,T1_0 to continuous - gap,T1 arrowstyle 1 linecolor rgb tint_of(set)
  set arrow from onset + gap,T1 to onset + gap,T2 arrowstyle 1 linecolor rgb tint_of(set)
  eval label_curve(short_of(set), is_printed(set) ? 29.114 : onset + gap, is_printed(set) ? 3550 : 1450, is_printed(set) ? "right" : "left offset 0.6,0")
}
plot [29.1:29.14] [0:4500] @each_set using "time_s":T @layered
