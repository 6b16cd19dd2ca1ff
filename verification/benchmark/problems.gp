# Right digits of each entry to the problems of rub against its time; hollow where it lacks quantities. data is by
# score.py --csv.
eval "set terminal ".size(960, 560).sprintf(" font 'DejaVu Sans,%d' enhanced rounded", letters)
set multiplot title "{/:Bold Problems of rub}: least right digits of each solver; hollow: not all quantities"
entries = "'event' 'published RK4' 'SciPy' 'CVODE'"
array tint[4] = [event_tint, "#e69f00", "#332288", "#999933"]    # methods are no equations
array mark[4] = [7, 5, 9, 13]
problems = ""
note(name) = (problems = strstrt(problems, "'".name."'") || name eq "problem" ? problems : problems."'".name."' ", 0)
stats data using (note(strcol("problem"))) nooutput
of(entry, problem, c) = strcol("problem") eq problem && strcol("entry")[1:strlen(entry)] eq entry ? column(c) : NaN
set logscale x; set xrange [1e-3:20]; set format x "10^{%T}"; set xtics 1e-2,10
set yrange [-0.7:15.7]; set ytics 5
unset key
per_row = 5
do for [n = 0:words(problems) - 1] {
  name = word(problems, n + 1)
  at_left = n % per_row == 0; at_bottom = n + per_row >= words(problems)
  set lmargin at screen 0.06 + 0.186*(n % per_row); set rmargin at screen 0.06 + 0.186*(n % per_row) + 0.17
  set tmargin at screen 0.86 - 0.37*(n/per_row); set bmargin at screen 0.86 - 0.37*(n/per_row) - 0.29
  set title name offset 0,-0.6
  set xlabel (at_bottom ? "time, s" : "") offset 0,0.4; set format x (at_bottom ? "10^{%T}" : "")
  set ylabel (at_left ? "right digits" : "") offset 0.5,0; set format y (at_left ? "%g" : "")
  plot for [k = 1:4] data using (of(word(entries, k), name, "seconds")):(of(word(entries, k), name, "digits")): \
    (mark[k] - (column("lacks") > 0)) with points pointtype variable pointsize 0.8 linecolor rgb tint[k] notitle
}
unset border; unset tics; unset title; unset xlabel; unset ylabel; unset logscale
set lmargin at screen 0; set rmargin at screen 1; set bmargin at screen 0; set tmargin at screen 0.1
set key at screen 0.5, screen 0.035 center center maxrows 1 Left reverse
plot [0:1] [0:1] for [k = 1:4] keyentry with points pointtype mark[k] linecolor rgb tint[k] title word(entries, k).(k == 1 ? ", ours" : ""), NaN notitle
unset multiplot
