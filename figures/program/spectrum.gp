# Spectra of displacement and force in the stator's frame. `rotor plot --spectrum` sets, besides what style.gp needs:
#   heading, runs, and for each run, by its number: name, from_s, until_s, samples, f and its range, f_n, and the whirl while it rolls
# Each run has a data file in gnuplot's folder: amplitudes by frequency, which is negative for backward whirl.

data(i) = sprintf("run%d.csv", i)
resolution(i) = 3.8/(of("until_s", i) - of("from_s", i))    # of the flat-top window: where its power is halved
said_of(i) = sprintf("%g s to %g s, resolution %.2g Hz: mean f = %.1f Hz%s%s", of("from_s", i), of("until_s", i), resolution(i), \
  of("f", i), of("f_greatest", i) - of("f_least", i) < resolution(i) ? "" : \
  sprintf(" (from %.1f to %.1f)", of("f_least", i), of("f_greatest", i)), \
  of("rolls", i) ? ", mean whirl while rolling ".signed("%.1f", of("whirl", i))." Hz" : "")

lowest = 0.8/(until_s1 - from_s1); highest = 0.25*samples1/(until_s1 - from_s1)
set logscale xy
set format x "%g"; set format y "10^{%T}"
set mxtics 10
top = 0.83 - 0.04*(runs - 1); bottom = 0.17; between = 0.05; height = 0.5*(top - bottom - between)
set multiplot
set label 1 "{/:Bold Spectrum}" at screen 0.5,0.97 center
set label 2 shortened(heading, 80) at screen 0.5,0.93 center noenhanced
rolling = 0    # the first run that rolls
do for [i = 1:runs] { rolling = !rolling && of("rolls", i) ? i : rolling }
set label 3 "Flat-top window: a circle at a steady frequency has its radius as height. Dashed: f; dotted: 2f".(rolling ? ", the whirl while rolling and f_n" : " and f_n") \
  at screen 0.5,0.03 center font small
do for [i = 1:runs] {
  set label (runs > 1 ? greek(of("run", i)).": " : "").said_of(i) at screen 0.5,screen 0.885 - 0.04*(i - 1) center \
    noenhanced font small textcolor linetype i
}

# The six decades below the largest amplitude.
decades = 1e-6
greatest_d = 0; greatest_F = 0
do for [i = 1:runs] {
  stats data(i) using (column("displacement_m")*1e3) nooutput; if (STATS_max > greatest_d) { greatest_d = STATS_max }
  stats data(i) using (column("force_N")/1e3) nooutput; if (STATS_max > greatest_F) { greatest_F = STATS_max }
}
mark(x, dash, text, i, row) = x >= lowest && x <= highest ? \
  sprintf("set arrow from first %g,graph 0 to first %g,graph 1 nohead back linetype %d linewidth 1 dashtype %s; ", x, x, i, dash). \
  (row == 0 && i == (text eq "whirl" ? rolling : 1) ? sprintf("set label '%s' at first %g,graph 1.06 center font small textcolor linetype %d; ", text, x, i) : "") : ""
do for [row = 0:1] { do for [forward = 0:1] {
  unset arrow
  do for [i = 1:runs] {
    if (forward) {
      eval mark(of("f", i), "(8,5)", "f", i, row).mark(2*of("f", i), "(2,4)", "2f", i, row)
    }
    is_close(x) = forward && x > 0 && of("f_n", i) > 0 && abs(log(of("f_n", i)/x)) < 0.35    # of two labels
    eval mark(of("f_n", i), "(2,4)", is_close(of("f", i)) || is_close(2*of("f", i)) ? "" : "f_n", i, row)
    if (of("rolls", i) && (of("whirl", i) > 0) == forward) {
      eval mark(abs(of("whirl", i)), "(2,4)", "whirl", i, row)
    }
  }
  set lmargin at screen forward ? 0.54 : 0.09; set rmargin at screen forward ? 0.965 : 0.515
  set tmargin at screen top - row*(height + between); set bmargin at screen top - row*(height + between) - height
  set xrange [lowest:highest]
  greatest = row == 0 ? greatest_d : greatest_F
  if (greatest > 0) { set yrange [decades*greatest:2*greatest] } else { set yrange [1e-3:1] }
  set xlabel (row == 1 ? (forward ? "forward, Hz" : "backward, Hz") : "") offset 0,0.4
  if (row == 0) { set format x "" } else { set format x "%g" }
  set ylabel (forward ? "" : row == 0 ? "r_O, mm" : "force, kN")
  if (greatest == 0) { set label (row == 0 ? "no motion" : "no contact") at graph 0.5,graph 0.5 center font small }
  if (forward) { set format y "" } else { set format y "10^{%T}" }
  unset key
  plot for [i = 1:runs] data(i) using (column("frequency_Hz")*(forward ? 1 : -1) > 0 ? abs(column("frequency_Hz")) : NaN): \
    (row == 0 ? column("displacement_m")*1e3 : column("force_N")/1e3) with lines linetype i
  unset label
} }
unset multiplot
