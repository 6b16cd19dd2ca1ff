# The trajectory of O in the stator's frame, gravity downwards.
eval "set terminal ".square
stats data using "time_s" name "window" nooutput
set title caption(9, "Trajectory of O in the stator's frame O_ax_ay_a", \
  friction("event").", ".sprintf("%g–%g s, ", window_min, window_max).loss("event")."; ".dotted("event"))
set size ratio -1
set xrange [-4:4]
set yrange [4:-4]
set xlabel "y_a, mm"
set ylabel "x_a (down), mm"
set object 1 circle at 0,0 size clearance_of("event") fillstyle empty border linecolor rgb black linewidth 1.2 dashtype (2,3)
set key at graph 0.98,0.98
mm(name, c) = of_run(name, c)*1e3
plot data using (mm("rk4", "y_a_m")):(mm("rk4", "x_a_m")) with lines linestyle fixed_steps \
    title by_method("rk4"), \
  data using (mm("event", "y_a_m")):(mm("event", "x_a_m")) with lines linetype 1 linewidth 1 title by_method("event")
