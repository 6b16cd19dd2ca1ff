# The trajectory of O in the stator's frame, gravity downwards.
eval "set terminal ".square
stats data using "time_s" name "window" nooutput
set title caption(9, "Trajectory of O in the stator's frame O_ax_ay_a", \
  friction("event").", ".sprintf("%g–%g s, ", window_min, window_max).loss("event")."; ".dotted("event"))
t_1 = number("event", "separation_time")
eval place_at("event", t_1, 0)
set label at y_1,x_1 point linestyle lost front
eval place_at("event", t_1 + 2e-3, 1e-5)
set arrow from y_1,x_1 to y_2,x_2 arrowstyle 5 front
eval place_at("event", window_max - 1e-3, 1e-6)
set arrow from y_1,x_1 to y_2,x_2 arrowstyle 5 front

set size ratio -1
set xrange [-4:4]
set yrange [4:-4]
set xlabel "y_a, mm"
set ylabel "x_a (down), mm"
set object 1 circle at 0,0 size clearance_of("event") fillstyle empty border linecolor rgb black linewidth 1.2 dashtype (2,3)
set key at graph 0.02,0.98 left top Left reverse maxrows 2
mm(name, c) = of_run(name, c)*1e3
plot data using (mm("rk4", "y_a_m")):(mm("rk4", "x_a_m")) with lines linestyle fixed_steps \
    title by_method("rk4"), \
  data using (mm("event", "y_a_m")):(mm("event", "x_a_m")) with lines linetype 1 linewidth 1 title by_method("event"), \
  data using (of_run("event", "time_s") == window_min ? mm("event", "y_a_m") : NaN):(mm("event", "x_a_m")) with points linestyle first_place \
    title sprintf("%g s", window_min), \
  keyentry with points linestyle lost title "mass loss", \
  keyentry with vectors arrowstyle 5 title "sense of motion" \
  @digitised
