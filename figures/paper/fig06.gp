# The kinetic energy while the rub develops, with the energies that the text states.
set title caption(6, "Kinetic energy T of the rotor", friction("run").", ".loss("run"))
set xlabel "t, s"
set ylabel "T, J"
set format x "%.3f"
T = "kinetic_energy_J"
stats data using (column("contact_state") == 2 ? column("time_s") : NaN) name "rolling" nooutput
stats data using (column("contact_state") > 0 ? column("time_s") : NaN) name "contact" nooutput
onset = rolling_min; t_1 = number("run", "mass_loss_time")
# The text's energies count continuous contact from the sixth touch-down.
touch_downs = 0; touching = 0; continuous = NaN
watch(t, state) = (state > 0 && !touching ? (touch_downs = touch_downs + 1, \
  continuous = touch_downs == 6 ? t : continuous) : 0, touching = state > 0, 0)
stats data using (watch(column("time_s"), column("contact_state"))) nooutput
stats data using (column("time_s") == onset ? column(T) : NaN) name "left" nooutput
stats data using (column("time_s") == continuous ? column(T) : NaN) name "ahead" nooutput
stats data using T name "all" nooutput
stats data using (column("time_s") == t_1 ? column(T) : NaN) name "separated" nooutput
T0 = all_max; T1_0 = separated_min; T1 = ahead_min; T2 = left_min

set xrange [29.1:29.14]
set yrange [0:4500]
set arrow from graph 0,first 4000 to graph 1,first 4000 nohead linestyle published
set arrow from graph 0,first (4000 - 1000) to graph 1,first (4000 - 1000) nohead linestyle published
set arrow from graph 0,first 1050 to graph 1,first 1050 nohead linestyle published
set label "paper: 4000 J" at graph 0.99,first 4000 right offset 0,0.6 textcolor rgb grey
set label "paper: −1000 J by collisions" at graph 0.01,first (4000 - 1000) offset 0,0.6 textcolor rgb grey
set label "paper: −1950 J by sliding, 1050 J left" at graph 0.01,first 1050 offset 0,0.6 \
  textcolor rgb grey
set label sprintf("here: %.0f J, and %.0f J after the mass loss", T0, T1_0) at t_1 + 3e-4,T0 offset 0,0.7
set arrow from continuous,graph 0 to continuous,graph 1 nohead linestyle reading
set arrow from onset,graph 0 to onset,graph 1 nohead linestyle reading
# Brackets from one energy to another.
gap = 4e-4                                         # s, from the vertical lines
set style arrow 1 heads size screen 0.006,90 linecolor rgb black linewidth 1
set arrow from continuous - gap,T1_0 to continuous - gap,T1 arrowstyle 1
set arrow from onset + gap,T1 to onset + gap,T2 arrowstyle 1
set label "collisions\n".signed("%.0f", T1 - T1_0)." J" at continuous - gap,2700 right boxed
set label "sliding\n".signed("%.0f", T2 - T1)." J" at onset + gap,0.5*(T1 + T2) left offset 1,0.5 boxed
set label sprintf("rolling\n%.0f J left", T2) at onset + gap,700 left boxed
plot data using "time_s":T with lines linestyle ours notitle \
  @digitised
