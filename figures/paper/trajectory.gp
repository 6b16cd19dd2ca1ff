# Trajectories of O in the stator's frame, gravity downwards, within the clearance of `run`.
subject = "Trajectory of O in the stator's frame O_ax_ay_a"
t_1 = number(run, "mass_loss_time")
stats data using "time_s" name "window" nooutput
set size ratio -1
set xlabel "y_a, mm"
set ylabel "x_a (down), mm"
set object 1 circle at 0,0 size clearance_of(run) fillstyle empty border linecolor rgb event_tint linewidth 1.2 dashtype (1,5)
set style arrow 5 head filled size screen 0.016,18,90 fixed linecolor rgb event_tint linewidth 1
# The place of O at a time: eval place("x_1", "y_1", t); an arrow along its path there: eval show_sense(t, a_little_s); and
# a panel of one set of equations: eval begin_panel(offset of the words); plot @orbit.
coordinate(name, c, t) = sprintf("stats data using (follow(of_run(run, 'time_s'), of_run(run, '%s'), %.17g)) nooutput; %s = 1e3*crossing; ", \
  c, t, name)
place(x, y, t) = coordinate(x, "x_a_m", t).coordinate(y, "y_a_m", t)
show_sense(t, later) = place("x_1", "y_1", t).place("x_2", "y_2", t + later)."set arrow from y_1,x_1 to y_2,x_2 arrowstyle 5 front"
begin_panel(offset) = "unset label; unset arrow; set title '{/:Bold '.words_of(set).'}' textcolor rgb tint_of(set) offset 0,-0.5; ". \
  place("x_1", "y_1", t_1)."set label 'mass loss' at y_1,x_1 left point linestyle lost offset ".offset." front"
orbit = '[-4:4] [4:-4] data using (1e3*column("y_a_m")):(1e3*column("x_a_m")) with lines linestyle ours linewidth 1 notitle'
