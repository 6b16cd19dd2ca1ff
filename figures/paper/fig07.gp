# q1 and rho as fast rolling sets in, one set of equations above the other; below, the spectra of O in rolling.
tall = 360. + 200*words(sets)
eval "set terminal ".size(960, tall).sprintf(" font 'DejaVu Sans,%d' enhanced rounded", letters)
panel(top, bottom) = sprintf("set lmargin at screen 0.07; set rmargin at screen 0.97; \
  set tmargin at screen %g; set bmargin at screen %g", 1 - top/tall, 1 - bottom/tall)
set multiplot title caption(7, "Generalised coordinate q_1 in the rotating axes, and displacement ρ", \
  friction("run").", ".loss("run")."; the axes turn at f, and O the other way at the whirl frequency: q_1 has their sum")
set ylabel "mm"
mark_height = 0.06
# The frequency of q1 from its zero crossings over the first 5 ms of rolling.
cross(t, q) = (t > onset && t < onset + 5e-3 && q0 < 0 && q >= 0 ? \
  (crossings = crossings + 1, last = t0 - q0*(t - t0)/(q - q0), first = crossings == 1 ? last : first) : 0, \
  t0 = t, q0 = q, 0)
early(c) = column("time_s") < 29.125 ? 1e3*column(c) : NaN
end = 29.15
do for [n = 1:words(sets)] {
  set = word(sets, n)
  eval use(set)
  unset label; unset arrow
  onset = number("run", "rolling_onset_s"); t0 = NaN; q0 = NaN; crossings = 0
  stats data using (cross(column("time_s"), column("q1_m"))) nooutput
  f_q = (crossings - 1)/(last - first); f = number("run", "rolling_onset_speed_Hz")
  set title sprintf("{/:Bold %s}: q_1 has %.1f Hz over %d periods from the onset, less f = %.1f Hz there: %.1f Hz; {/:Normal paper: 770 Hz}", \
    words_of(set), f_q, crossings - 1, f, f_q - f) \
    textcolor rgb tint_of(set) offset 0,-0.5
  eval mark_instant(sprintf("rolling from %.4f s", onset), onset)
  eval level(3.5, published).says("paper: ρ ≈ 3.5 mm", 0.985, 3.5, "right offset 0,0.7 boxed")
  # Labels where each extends furthest in the first sixth.
  stats data using "time_s":(early("q1_m")) name "q" nooutput
  stats data using "time_s":(early("rho_m")) name "rho" nooutput
  set label "q_1" at q_pos_min_y,q_min_y center offset 0,-0.8
  set label "ρ" at rho_pos_max_y,rho_max_y center offset 0,0.9
  is_last = n == words(sets)
  set xlabel (is_last ? "t, s" : "") offset 0,0.4; set format x (is_last ? "%.3f" : "")
  eval panel(90 + 200*(n - 1), 250 + 200*(n - 1))
  set ytics 2
  plot [29.12:end] [-5.2:5] data using "time_s":(column("q1_m")*1e3) with lines linestyle ours notitle, \
       data using "time_s":(column("rho_m")*1e3) with lines linestyle ours linewidth 2.2 notitle
}

# The mean of z exp(-i 2 pi f t) over rolling in Hann's window, of every sixth row: in the stator's axes
# and in the rotating ones.
i = {0, 1}
do for [set in sets] {
  eval use(set)
  onset = number("run", "rolling_onset_s"); before = onset
  hann(t) = (1 - cos(2*pi*(t - onset)/(end - onset)))/(end - onset)
  set table $rolling
  plot data every 6 using (sprintf("%.9f %.9f %.9f %.9f %.9f", column("time_s"), column("x_a_m"), column("y_a_m"), \
    column("q1_m"), column("q2_m"))) with table if (column("time_s") > onset)
  unset table
  rows = |$rolling|
  array t[rows]; array in_stator[rows]; array in_rotating[rows]
  do for [k = 1:rows] {
    of_row(n) = real(word($rolling[k], n))
    t[k] = of_row(1); share = 1e3*hann(t[k])*(t[k] - before); before = t[k]
    in_stator[k] = share*(of_row(2) + i*of_row(3)); in_rotating[k] = share*(of_row(4) + i*of_row(5))
  }
  eval sprintf("set print $spectrum_%s", set)
  do for [f = -1000:1000:10] {
    print sprintf("%d,%g,%g", f, abs(sum [k = 1:rows] in_stator[k]*exp(-2*pi*i*f*t[k])), \
      abs(sum [k = 1:rows] in_rotating[k]*exp(-2*pi*i*f*t[k])))
  }
  unset print
}
unset label; unset arrow
eval panel(140 + 200*words(sets), 290 + 200*words(sets))
set xlabel "against the rotation  ←  frequency, Hz"; set format x "%g"
eval sprintf("set arrow from -770,graph 0 to -770,graph 1 nohead linestyle %d", published)
set style line 21 linecolor rgb tint_of("corrected") dashtype (6,4)
curves(n, step) = sprintf("for [set in from_below] '$spectrum_'.set every ".step." using 1:%d with lines linestyle layer(set) linewidth %g notitle", n, n == 2 ? 2.2 : 1)
set rmargin at screen 0.54
set title "{/:Bold Spectrum of O}, in rolling to 29.15 s; thin: in the axes of q_1" \
  textcolor default offset 0,-0.5
set label "paper: about 770 Hz" at graph 0.985,graph 0.9 right textcolor rgb paper_tint
set xtics 50; set ytics 1
eval "plot [-950:-600] [0:4] ".curves(2, 1).", ".curves(3, 1)
unset label
set lmargin at screen 0.6; set rmargin at screen 0.97
set title "both senses, in the stator's axes, mm".(words(sets) == 2 ? "; dashed: corrected" : "") textcolor default offset 0,-0.5
set xlabel "against the rotation  ←  frequency, Hz  →  with it"
set logscale y; set xtics 500; set ytics 10; unset ylabel
eval "plot [-1000:1000] [1e-3:10] ".curves(2, 2)
unset multiplot
