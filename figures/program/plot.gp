# Force, speed, displacement and orbit of any scene. `rotor plot` sets, beside what style.gp wants:
#   heading, runs, the names run1, run2, ... and clearance_mm1, clearance_mm2, ...
# In the data runs have their numbers for names.

gap(i) = value(sprintf("clearance_mm%d", i))
name(i) = value(sprintf("run%d", i))
of(i, c) = of_run(sprintf("%d", i), c)
greater(a, b) = a > b ? a : b
short(text, most) = strlen(text) > most ? text[:most - 1]."…" : text

# One key for all panels, in rows under the title, where it hides no curve. Lengths here and below are parts of
# the picture's width or height, and those of letters are the png's, which has the widest.
letter = 0.01; longest_name = 36; most_rows = 8
longest = strlen("clearance")
if (runs > 1) { do for [i = 1:runs] { longest = greater(longest, strlen(short(name(i), longest_name))) } }
key_width = 0.045 + letter*longest; columns = int(0.9/key_width)
entries = runs > 1 ? runs + 1 : 1
named = entries > most_rows*columns ? most_rows*columns - 2 : entries - 1
entries = entries > named + 1 ? named + 2 : entries
rows = (entries + columns - 1)/columns
key_x(k) = 0.5 + key_width*(k % columns - 0.5*(entries < columns ? entries : columns))
key_y(k) = 0.925 - 0.034*(k/columns)
do for [k = 0:entries - 1] {
  says = k < named ? short(name(k + 1), longest_name) : k == named ? "clearance" : sprintf("and %d more runs", runs - named)
  set label says at screen key_x(k) + 0.035, screen key_y(k) noenhanced font small
  if (k < named) { set arrow from screen key_x(k), screen key_y(k) rto screen 0.03, screen 0 nohead linetype k + 1 }
  if (k == named) { set arrow from screen key_x(k), screen key_y(k) rto screen 0.03, screen 0 nohead linestyle clearance }
}

set multiplot layout 2,2 title short(heading, 80) noenhanced margins 0.1,0.97,0.1,0.92 - 0.034*rows spacing 0.12,0.13
unset key
set xlabel "t, s" offset 0,0.4
set ylabel "F_n, kN" offset -0.5,0
plot for [i = 1:runs] data using (of(i, "time_s")):(of(i, "normal_force_N")/1e3) \
  with lines linetype i
unset label; unset arrow
set ylabel "f, Hz"
plot for [i = 1:runs] data using (of(i, "time_s")):(of(i, "speed_Hz")) with lines linetype i
set ylabel "rho, mm"
plot for [i = 1:runs] gap(i) with lines linestyle clearance, \
  for [i = 1:runs] data using (of(i, "time_s")):(of(i, "rho_m")*1e3) with lines linetype i
set ylabel "x_a, mm (down)"
set xlabel "y_a, mm"
set size ratio -1
set yrange [] reverse
set parametric
set trange [0:2*pi]
plot for [i = 1:runs] gap(i)*cos(t), gap(i)*sin(t) with lines linestyle clearance, \
  for [i = 1:runs] data using (of(i, "y_a_m")*1e3):(of(i, "x_a_m")*1e3) with lines linetype i
unset multiplot
