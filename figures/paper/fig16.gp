# The trajectory of O in the stator's frame, gravity downwards.
eval "set terminal ".square
stats data using "time_s" name "window" nooutput
set title caption(16, "Trajectory of O in the stator's frame O_ax_ay_a", \
  sprintf("%g–%g s, ", window_min, window_max).loss("run")."; ".dotted("run"))
t_1 = number("run", "mass_loss_time")
mm(c) = column(c)*1e3
eval place_at("run", t_1, 0)
set label "mass loss" at y_1,x_1 left point linestyle lost offset 0.5,1.6 front
eval place_at("run", t_1 + 8e-3, 1e-5)
set arrow from y_1,x_1 to y_2,x_2 arrowstyle 5 front
eval place_at("run", window_max - 0.05, 1e-5)
set arrow from y_1,x_1 to y_2,x_2 arrowstyle 5 front

set size ratio -1
set xrange [-4:4]
set yrange [4:-4]
set xlabel "y_a, mm"
set ylabel "x_a (down), mm"
set object 1 circle at 0,0 size clearance_of("run") fillstyle empty border linecolor rgb black linewidth 1.2 dashtype (1,5)
plot data using (mm("y_a_m")):(mm("x_a_m")) with lines linestyle ours linewidth 1 notitle \
  @digitised
