# Trajectories of O in the stator's frame, gravity downwards, within the clearance of `run`.
subject = "Trajectory of O in the stator's frame O_ax_ay_a"
t_1 = number(run, "mass_loss_time")
stats data using "time_s" name "window" nooutput
set size ratio -1
set xlabel "y_a, mm"
set ylabel "x_a (down), mm"
set object 1 circle at 0,0 size clearance_of(run) fillstyle empty border linecolor rgb event_tint linewidth 1.2 dashtype (1,5)
# The place of O at a time: eval place("x_1", "y_1", t); an arrow along its path there: eval show_sense(t, a_little_s); and
# a panel of one set of equations: eval begin_panel(offset of the words); plot @orbit.
coordinate(name, c, t) = sprintf("stats data using (follow(of_run(run, 'time_s'), of_run(run, '%s'), %.17g)) nooutput; %s = 1e3*crossing; ", \
  c, t, name)
place(x, y, t) = coordinate(x, "x_a_m", t).coordinate(y, "y_a_m", t)
# A number beside a place, further out from O_a where there is one already; and where O leaves the circle of the
# clearance between two times: eval number_exits(from, until). Where it is inside for less than the curve shows, it has none.
near(y, x) = sum [k = 1:words(placed)/2] (abs(y - real(word(placed, 2*k - 1))) + abs(x - real(word(placed, 2*k))) < 0.6)
beside(y, x, n, gap) = (placed = placed.sprintf(" %.3f %.3f", y, x), far = 1 + (gap + 0.45*(near(y, x) - 1))/sqrt(x*x + y*y), \
  sprintf("set label '%d' at %.4g,%.4g center font ',%g' front; ", n, far*y, far*x, 0.65*letters))
leaves(name, t, x, y) = (now = x*x + y*y > rim, now && !out && name eq run ? (exits = exits + 1, \
  marks = marks.(t >= t_from && t <= t_until ? beside(1e3*y, 1e3*x, exits, 0.35) : "")) : 0, \
  out = name eq run ? now : out, 0)
rim = (1 - 1e-9)*(1e-3*clearance_of(run))**2
number_exits(from, until) = sprintf("exits = 0; out = 0; marks = ''; placed = ''; t_from = %.17g; t_until = %.17g; ", from, until). \
  "stats data using (leaves(strcol('run'), column('time_s'), column('x_a_m'), column('y_a_m'))) nooutput; eval marks"
show_sense(t, later) = place("x_1", "y_1", t).place("x_2", "y_2", t + later)."set arrow from y_1,x_1 to y_2,x_2 arrowstyle 5 front"
begin_panel(offset) = "unset label; unset arrow; set title '{/:Bold '.words_of(set).'}' textcolor rgb tint_of(set) offset 0,-0.5; ". \
  place("x_1", "y_1", t_1)."set label 'mass loss' at y_1,x_1 left point linestyle lost offset ".offset." front"
orbit = '[-4:4] [4:-4] data using (1e3*column("y_a_m")):(1e3*column("x_a_m")) with lines linestyle ours linewidth 1 notitle'
