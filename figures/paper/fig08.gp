# The trajectory of O in the stator's frame, gravity downwards.
t_1 = number("run", "mass_loss_time")
set multiplot layout 1,words(sets) margins 0.08,0.98,0.12,0.84 spacing 0.08,0 \
  title caption(8, "Trajectory of O in the stator's frame O_ax_ay_a", \
  friction("run").", ".loss("run")."; until 7 ms after the onset of rolling; ".dotted("run"))
mm(c) = column(c)*1e3
set size ratio -1
set xlabel "y_a, mm"
set ylabel "x_a (down), mm"
set object 1 circle at 0,0 size clearance_of("run") fillstyle empty border linecolor rgb black linewidth 1.2 dashtype (1,5)
do for [set in sets] {
  eval use(set)
  unset label; unset arrow
  set title "{/:Bold ".words_of(set)."}" textcolor rgb tint_of(set) offset 0,-0.5
  stats data using (column("contact_state") == 2 ? column("time_s") : NaN) name "rolling" nooutput
  end = rolling_min + 7e-3
  eval place_at("run", t_1, 0)
  set label "mass loss" at y_1,x_1 left point linestyle lost offset 0.8,0.4 front
  eval place_at("run", t_1 + 2e-3, 1e-5)
  set arrow from y_1,x_1 to y_2,x_2 arrowstyle 5 front
  eval place_at("run", end - 2e-4, 1e-6)
  set arrow from y_1,x_1 to y_2,x_2 arrowstyle 5 front
  plot [-4:4] [4:-4] data using (column("time_s") < end ? mm("y_a_m") : NaN):(mm("x_a_m")) with lines linestyle ours linewidth 1 notitle
}
