# Spectra of displacement and force in the stator's frame. `rotor plot --spectrum` sets, besides what style.gp needs:
#   heading, conditions in a number of lines, known_runs, and for each run, by its number: name, from_s, until_s, samples, f and its range, f_n, and the whirl while it rolls
# Each run has a data file in gnuplot's folder: amplitudes by frequency, which is negative for backward whirl.

runs = known_runs
data(i) = sprintf("run%d.csv", i)
resolution(i) = 3.8/(of("until_s", i) - of("from_s", i))    # of the flat-top window: where its power is halved
# A table of numbers in place of a key: a row for each run.
array table_x[6] = [0.09, 0.38, 0.5, 0.61, 0.77, 0.965]
array heads[6] = ["run", "from–to, s", "resolution, Hz", "mean f, Hz", "f from–to, Hz", "whirl while rolling, Hz"]
array cells[6]
fill(i) = (cells[1] = shortened(greek(of("run", i)), 30), cells[2] = sprintf("%.4g–%.4g", of("from_s", i), of("until_s", i)), \
  cells[3] = sprintf("%.2g", resolution(i)), cells[4] = sprintf("%.1f", of("f", i)), \
  cells[5] = sprintf("%.1f–%.1f", of("f_least", i), of("f_greatest", i)), \
  cells[6] = of("rolls", i) ? signed("%.1f", of("whirl", i)) : "–")

lowest = 0.8/(until_s1 - from_s1); highest = 0.25*samples1/(until_s1 - from_s1)
set logscale xy
set format x "%g"; set format y "10^{%T}"
set mxtics 10
top = 0.826 - 0.026*lines - 0.035*runs; bottom = 0.17; between = 0.05; height = 0.5*(top - bottom - between)
set multiplot
set label 1 shortened("Spectrum: ".heading, 80) at screen 0.5,0.975 center noenhanced
set label 2 conditions at screen 0.5,0.938 center noenhanced font small
rolling = 0    # the first run that rolls
do for [i = 1:runs] { rolling = !rolling && of("rolls", i) ? i : rolling }
set label 3 "Flat-top window: a circle at a steady frequency has its radius as height. Dashed: f; dotted: 2f".(rolling ? ", the whirl while rolling and f_n" : " and f_n") \
  at screen 0.5,0.03 center font small
do for [i = 0:runs] {
  if (i > 0) { void = fill(i) }
  tint = i > 0 ? i : 4
  set label (i > 0 ? cells[1] : heads[1]) at screen table_x[1],screen 0.921 - 0.026*lines - 0.035*i left noenhanced font small textcolor linetype tint
  do for [k = 2:6] {
    set label (i > 0 ? cells[k] : heads[k]) at screen table_x[k],screen 0.921 - 0.026*lines - 0.035*i right noenhanced font small
  }
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
