# q1 and rho as fast rolling sets in.
set xlabel "t, s"
set ylabel "mm"
set format x "%.3f"
stats data using (column("contact_state") == 2 ? column("time_s") : NaN) name "rolling" nooutput
# The frequency of q1 from its zero crossings over the first 5 ms of rolling.
begin = rolling_min; end = begin + 5e-3
t0 = NaN; q0 = NaN; first = NaN; last = NaN; crossings = 0
cross(t, q) = (t > begin && t < end && q0 < 0 && q >= 0 ? \
  (crossings = crossings + 1, last = t0 - q0*(t - t0)/(q - q0), first = crossings == 1 ? last : first) : 0, \
  t0 = t, q0 = q, 0)
stats data using (cross(column("time_s"), column("q1_m"))) nooutput
set xrange [29.12:29.15]
set title caption(7, "Generalised coordinate q_1 in the rotating axes, and displacement ρ", \
  sprintf("%s, %s; frequency of q_1 in the first %d periods of rolling: %.0f Hz, paper: about 770 Hz", \
    friction("run"), loss("run"), crossings - 1, (crossings - 1)/(last - first)))
set yrange [-4.8:4.8]
set arrow from rolling_min,graph 0 to rolling_min,graph 1 nohead linestyle reading
set label sprintf("rolling\nfrom %.4f s", rolling_min) at rolling_min,4.4 right offset -1,0 textcolor rgb grey
set label "paper: ρ ≈ 3.5 mm" at graph 0.985,first 3.5 right offset 0,0.7 textcolor rgb grey boxed front
set arrow from graph 0,first 3.5 to graph 1,first 3.5 nohead linestyle published
# Labels where each extends furthest in the first sixth.
early(c) = column("time_s") < 29.125 ? 1e3*column(c) : NaN
stats data using "time_s":(early("q1_m")) name "q" nooutput
stats data using "time_s":(early("rho_m")) name "rho" nooutput
set label "q_1" at q_pos_min_y,q_min_y center offset 0,-0.8
set label "ρ" at rho_pos_max_y,rho_max_y center offset 0,0.9 boxed front
plot data using "time_s":(column("q1_m")*1e3) with lines linestyle ours notitle, \
     data using "time_s":(column("rho_m")*1e3) with lines linestyle ours linewidth 2.2 notitle \
  @digitised
