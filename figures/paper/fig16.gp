# The trajectory of O in the stator's frame, gravity downwards.
eval "set terminal ".square
stats data using "time_s" name "window" nooutput
set title caption(16, "Trajectory of O in the stator's frame O_ax_ay_a", \
  sprintf("%g–%g s, ", window_min, window_max).loss("run")."; ".dotted("run"))
set size ratio -1
set xrange [-4:4]
set yrange [4:-4]
set xlabel "y_a, mm"
set ylabel "x_a (down), mm"
unset key
set object 1 circle at 0,0 size clearance_of("run") fillstyle empty border linecolor rgb black linewidth 1.2 dashtype (2,3)
plot data using (column("y_a_m")*1e3):(column("x_a_m")*1e3) with lines linetype 1 linewidth 1
