# The velocities in rolling without slipping, at the onset of rolling: directions and velocities are the
# computed ones; only the clearance is enlarged.
eval "set terminal ".square
enlarged = 5                                       # the clearance, as the title says
set title caption(10, "Velocities in rolling along the ring without slipping", \
  "state at the computed onset of rolling, ".friction("run")."; picture: ".words_of(equations). \
  sprintf(", clearance enlarged %d times", enlarged))
r = number("run", "rotor_radius")
eval table(0.1, 0.215, 27)
eval row(1, "onset of rolling, s", ""); eval row(2, "displacement ρ", "3.5 mm"); eval row(3, "rotation speed f", "45 Hz")
eval row(4, "whirl f_{rol} = f r/ρ, Eq. (26)", "771.4 Hz"); eval row(5, "velocity v_O", "16.9 m/s")

# The mean whirl over the window: the sum of the angles by which O turns about O_a from row to row.
turn(x, y) = (turned = x_1 == x_1 ? turned + atan2(x_1*y - y_1*x, x_1*x + y_1*y) : 0, x_1 = x, y_1 = y, 0)
do for [set in from_below] {                       # so that the picture is of the first
  eval use(set)
  # The state at the onset: the first row.
  stats data every ::0::0 using "x_a_m" name "x" nooutput
  stats data every ::0::0 using "y_a_m" name "y" nooutput
  stats data every ::0::0 using "rho_m" name "rho" nooutput
  f = number("run", "rolling_onset_speed_Hz")
  rho = rho_max; f_rol = f*r/rho                   # Eq. (26)
  v_O = 2*pi*f_rol*rho                             # m/s, against the sense of rotation
  x_1 = NaN; y_1 = NaN; turned = 0
  stats data using (turn(column("x_a_m"), column("y_a_m"))) nooutput
  stats data using "time_s" name "window" nooutput
  length = window_max - window_min
  eval ours_in(1, sprintf("%.5f", number("run", "rolling_onset_s"))); eval ours_in(2, sprintf("%.3f mm", 1e3*rho))
  eval ours_in(3, sprintf("%.2f Hz", f)); eval ours_in(4, sprintf("%.1f Hz", f_rol))
  eval ours_in(5, sprintf("%.2f m/s", v_O)); eval ours_in(6, sprintf("%.1f Hz", -turned/(2*pi*length)))
}
eval row(6, sprintf("mean whirl of O in the next %.1f ms", 1e3*length), "")

# On the page: y_a to the right, x_a downwards. Lengths in units of the ring's radius.
drawn = enlarged*rho/(r + rho)                     # rho on the page
nx = y_max/rho; ny = -x_max/rho                    # direction O_a -> O -> K
tx = -ny; ty = nx                                  # sense of the rotor's rotation
Ox = drawn*nx; Oy = drawn*ny
Kx = nx; Ky = ny
radius = 1 - drawn
u = 0.55/v_O                                       # length of an arrow per m/s

set size ratio -1
set xrange [-1.25:1.35]
set yrange [-1.75:1.12]
unset border; unset tics; unset grid; unset key
set style arrow 1 linecolor rgb tint_of(equations) linewidth 2.2 filled size 0.06,18
set style arrow 3 linecolor rgb event_tint linewidth 1.2 filled size 0.05,18
set style arrow 4 nohead linecolor rgb event_tint linewidth 1 dashtype (3,3)

set object 2 circle at Ox,Oy size radius fillcolor rgb "#f2f2f2" fillstyle solid border linecolor rgb event_tint linewidth 1.5
set object 3 circle at 0,0 size 0.018 fillcolor rgb event_tint fillstyle solid front
set object 4 circle at Ox,Oy size 0.018 fillcolor rgb event_tint fillstyle solid front
set object 5 circle at Kx,Ky size 0.024 fillcolor rgb event_tint fillstyle solid front
set object 6 circle at 0,0 size drawn fillstyle empty border linecolor rgb event_tint linewidth 1 dashtype (2,3) front
Px = Ox - radius*nx; Py = Oy - radius*ny           # the rim point opposite to K

# Velocities of a body that turns about K at this instant.
set arrow from Kx,Ky to Px,Py arrowstyle 4
set arrow from Kx,Ky to Px - 2*v_O*u*tx,Py - 2*v_O*u*ty arrowstyle 4 front
set arrow from Ox,Oy to Ox - v_O*u*tx,Oy - v_O*u*ty arrowstyle 1 front
set arrow from Px,Py to Px - 2*v_O*u*tx,Py - 2*v_O*u*ty arrowstyle 1 front
set label "O_a" at 0,0 right offset -0.6,0.6 front
set label "O" at Ox,Oy offset 0.8,-0.8 front
set label "path of O" at 0,-drawn right offset 0,-0.8 front
set label "{/:Bold K}" at 1.09*Kx,1.09*Ky center front
set label "v_K = 0" at 1.2*Kx,1.2*Ky center front
# Beyond the tips, on the side to which they point.
side = tx < 0 ? "left offset 0.8,0" : "right offset -0.8,0"
set label sprintf("v_O = %.1f m/s", v_O) at Ox - 0.5*v_O*u*tx,Oy - 0.5*v_O*u*ty left offset 0.5,-1 front
set label sprintf("%.1f m/s", 2*v_O) at Px - 2*v_O*u*tx,Py - 2*v_O*u*ty @side front
# About O, f turns with the sense of rotation; about O_a, f_rol turns against it.
arc(a, b, t) = a + (b - a)*t
set parametric
set trange [0:1]
whirl_angle = atan2(ny, nx)
turning = 0.22                                     # the radius of the arrow about O, from v_O past K
begin = whirl_angle - 1.2; end = whirl_angle + 2.3
set arrow from Ox + turning*cos(end - 0.25),Oy + turning*sin(end - 0.25) to Ox + turning*cos(end),Oy + turning*sin(end) \
  linecolor rgb event_tint linewidth 1.6 filled size 0.06,18 front
set label "f" at Ox + 1.3*turning*cos(whirl_angle + 1.5),Oy + 1.3*turning*sin(whirl_angle + 1.5) center front
set arrow from 1.1*cos(whirl_angle - 0.9),1.1*sin(whirl_angle - 0.9) \
  to 1.1*cos(whirl_angle - 1.0),1.1*sin(whirl_angle - 1.0) \
  linecolor rgb event_tint linewidth 1.6 filled size 0.06,18 front
set label "f_{rol}" at 1.18*cos(whirl_angle - 0.65),1.18*sin(whirl_angle - 0.65) center front

plot cos(2*pi*t),sin(2*pi*t) with lines linecolor rgb event_tint linewidth 3, \
     Ox + turning*cos(arc(begin, end - 0.2, t)),Oy + turning*sin(arc(begin, end - 0.2, t)) \
       with lines linecolor rgb event_tint linewidth 1.6, \
     1.1*cos(whirl_angle - arc(0.25, 0.98, t)),1.1*sin(whirl_angle - arc(0.25, 0.98, t)) \
       with lines linecolor rgb event_tint linewidth 1.6
