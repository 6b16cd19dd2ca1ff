# Right digits of each entry to the problems of rub against its time and right-hand sides; hollow where it lacks
# quantities. data is by score.py --csv.
eval "set terminal ".size(960, 1000).sprintf(" font 'DejaVu Sans,%d' enhanced rounded", letters)
set multiplot title "{/:Bold Problems of rub}: least right digits of each solver; hollow or ×: not all quantities"
entries = "'event' 'published RK4' 'SciPy' 'CVODE' 'GSL' 'Odeint' 'LIGGGHTS'"
array tint[7] = [event_tint, "#e69f00", "#882255", "#44aa99", "#332288", "#999933", paper_tint]  # methods are no equations
array mark[7] = [7, 5, 9, 13, 11, 15, 3]                                                        # solid; one less is hollow
problems = ""
note(name) = (problems = strstrt(problems, "'".name."'") || name eq "problem" ? problems : problems."'".name."' ", 0)
stats data using (note(strcol("problem"))) nooutput
of(entry, problem, c) = strcol("problem") eq problem && strcol("entry")[1:strlen(entry)] eq entry ? column(c) : NaN
set logscale x
set yrange [-1:16]; set ytics 5; unset mxtics
unset key
do for [n = 0:words(problems) - 1] {
  name = word(problems, n + 1); top = 0.93 - 0.165*(n/2)
  set tmargin at screen top; set bmargin at screen top - 0.127
  at_bottom = n > words(problems) - 3
  do for [i = 0:1] {
    cost = word("seconds right_hand_sides", i + 1); left = 0.055 + 0.485*(n % 2) + 0.229*i
    set lmargin at screen left; set rmargin at screen left + 0.215
    if (i) { set xrange [200:2e8]; set xtics 1e3,100 } else { set xrange [2e-5:200]; set xtics 1e-4,100 }
    if (!i) { set label 1 name at screen left + 0.222, screen top + 0.012 center }
    set xlabel (at_bottom ? word("'time, s' 'right-hand sides'", i + 1) : "") offset 0,0.4
    set format x (at_bottom ? "10^{%T}" : "")
    set ylabel (n % 2 || i ? "" : "right digits") offset 0.5,0; set format y (i ? "" : "%g")
    plot for [k = 1:words(entries)] data \
      using (of(word(entries, k), name, cost)):(of(word(entries, k), name, "digits")):(mark[k] - (column("lacks") > 0)) \
      with points pointtype variable pointsize 0.8 linecolor rgb tint[k] notitle
    unset label 1
  }
}
unset border; unset tics; unset xlabel; unset ylabel; unset logscale
set lmargin at screen 0; set rmargin at screen 1; set bmargin at screen 0; set tmargin at screen 0.06
set key at screen 0.5, screen 0.03 center center maxrows 2 Left reverse
plot [0:1] [0:1] for [k = 1:words(entries)] \
  keyentry with points pointtype mark[k] linecolor rgb tint[k] title word(entries, k).(k == 1 ? ", ours" : ""), NaN notitle
unset multiplot
