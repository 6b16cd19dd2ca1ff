# Force, speed, displacement and orbit of any scene. `rotor plot` sets, besides what style.gp needs:
#   heading, conditions in a number of lines, and what it writes beside the data of a figure
# Each run has a data file for each panel in gnuplot's folder, named after the column that is drawn upwards.

runs = known_runs
gap(i) = 1e3*(of("stator_radius", i) - of("rotor_radius", i))
name(i) = greek(of("run", i))
data(i, c) = sprintf("run%d-%s.csv", i, c)
greater(a, b) = a > b ? a : b
wide(i) = 1 + greater(0, (runs < 4 ? runs : 4) - i)    # width of a run over which others are drawn

# One key for all panels, in rows under the title, where it hides no curve. Lengths here and below are relative
# to the picture's width or height; widths of letters are those of png, the widest.
letter = 0.01; longest_name = 36; most_rows = 8
longest = strlen("clearance")
if (runs > 1) { do for [i = 1:runs] { longest = greater(longest, strlen(shortened(name(i), longest_name))) } }
key_width = 0.045 + letter*longest; columns = int(0.9/key_width)
entries = runs > 1 ? runs + 1 : 1
named = entries > most_rows*columns ? most_rows*columns - 2 : entries - 1
entries = entries > named + 1 ? named + 2 : entries
rows = (entries + columns - 1)/columns
key_x(k) = 0.5 + key_width*(k % columns - 0.5*(entries < columns ? entries : columns))
key_y(k) = 0.916 - 0.026*lines - 0.034*(k/columns)
do for [k = 0:entries - 1] {
  says = k < named ? shortened(name(k + 1), longest_name) : k == named ? "clearance" : sprintf("and %d more runs", runs - named)
  set label says at screen key_x(k) + 0.035, screen key_y(k) noenhanced font small
  if (k < named) { set arrow from screen key_x(k), screen key_y(k) rto screen 0.03, screen 0 nohead linetype k + 1 linewidth wide(k + 1) }
  if (k == named) { set arrow from screen key_x(k), screen key_y(k) rto screen 0.03, screen 0 nohead linestyle clearance }
}
top = 0.911 - 0.026*lines - 0.034*rows; bottom = 0.1; between = 0.13
height = 0.5*(top - bottom - between)

# Axes end at tics, which are 1, 2 or 5 times a power of ten apart. Their labels have enough digits to differ. There
# are n steps, or fewer if labels would not fit. A constant curve has some space around it.
nice(x) = (power = 10.0**floor(log10(x)), (x < 1.001*power ? 1 : x < 2.001*power ? 2 : x < 5.001*power ? 5 : 10)*power)
between_tics(a, b) = (low = step*floor(a/step + 1e-6), high = step*ceil(b/step - 1e-6), \
  letters = greater(strlen(sprintf(form, low)), strlen(sprintf(form, high))))
fit(a, b, n, room) = (step = nice((b - a)/n), form = sprintf("%%.%df", step < 1 ? ceil(-log10(step) - 1e-6) : 0), \
  between_tics(a, b), n > 1 && (high - low)/step*(letters + 1)*letter > room ? fit(a, b, n - 1, room) : letters)
changes(a, b) = b - a > 1e-12*greater(abs(a), abs(b))
around(a) = a == 0 ? 1 : 0.01*abs(a)
show(a, b, n, room) = changes(a, b) ? fit(a, b, n, room) : fit(a - around(a), b + around(a), n, room)
axis(c, from, to) = sprintf("set %srange [%.17g:%.17g]; set %stics %.17g; set format %s '%s'", \
  c, from - 1e-5*(to - from), to + 1e-5*(to - from), c, step, c, form)    # rounding must cut nothing off

# The limits of all runs' data and clearances.
less(a, b) = a < b ? a : b
do for [i = 1:runs] {
  do for [c in "time_s normal_force_N speed_Hz rho_m x_a_m y_a_m"] {
    stats data(i, c eq "time_s" ? "speed_Hz" : c eq "y_a_m" ? "x_a_m" : c) using (column(c)) name "its" nooutput
    eval sprintf("least_%s = i > 1 ? less(least_%s, its_min) : its_min", c, c)
    eval sprintf("most_%s = i > 1 ? greater(most_%s, its_max) : its_max", c, c)
  }
  widest_gap = i > 1 ? greater(widest_gap, gap(i)) : gap(i)
  least_gap = i > 1 ? less(least_gap, gap(i)) : gap(i)
}
widest = show(least_normal_force_N/1e3, most_normal_force_N/1e3, 5, 1); force_axis = axis("y", low, high)
widest = greater(widest, show(least_speed_Hz, most_speed_Hz, 5, 1)); speed_axis = axis("y", low, high)
rho_min = less(1e3*least_rho_m, 0.98*least_gap); rho_max = greater(1e3*most_rho_m, 1.02*widest_gap)
widest = greater(widest, show(rho_min, rho_max, 5, 1)); rho_axis = axis("y", low, high)
down_min = less(1e3*least_x_a_m, -widest_gap); down_max = greater(1e3*most_x_a_m, widest_gap)
right_min = less(1e3*least_y_a_m, -widest_gap); right_max = greater(1e3*most_y_a_m, widest_gap)
half = 0.5*greater(down_max - down_min, right_max - right_min)

# An orbit for each run, in rows within the last panel.
in_a_row = runs > 1 ? int(ceil(sqrt(2.0*runs))) : 1; if (in_a_row > runs) { in_a_row = runs }
orbit_rows = (runs + in_a_row - 1)/in_a_row
orbit_height = (height + 0.06)/orbit_rows - 0.06
void = fit(-half, half, 5, less(0.58*orbit_height, 0.4/in_a_row - 0.06))    # as wide as high
widest = greater(widest, between_tics(down_min, down_max)); down_axis = axis("y", high, low)
void = between_tics(right_min, right_max); right_axis = axis("x", low, high)
left = 0.055 + letter*widest
time_letters = show(least_time_s, most_time_s, 8, 0.44 - left); right = 0.01 + 0.5*letter*time_letters

set label shortened(heading, 80) at screen 0.5,screen 0.97 center noenhanced
set label conditions at screen 0.5,screen 0.93 center noenhanced font small
set multiplot layout 2,2 margins left,1 - right,bottom,top spacing left + right,between
unset key
if (changes(least_time_s, most_time_s)) { low = least_time_s; high = most_time_s }
eval axis("x", low, high)
set xlabel "t, s" offset 0,0.4
set ylabel "F_n, kN" offset -0.5,0
eval force_axis
plot for [i = 1:runs] data(i, "normal_force_N") using (column("time_s")):(column("normal_force_N")/1e3) with lines linetype i linewidth wide(i)
unset label; unset arrow
set ylabel "f, Hz"
eval speed_axis
plot for [i = 1:runs] data(i, "speed_Hz") using (column("time_s")):(column("speed_Hz")) with lines linetype i linewidth wide(i)
set ylabel "ρ, mm"
eval rho_axis
plot for [i = 1:runs] data(i, "rho_m") using (column("time_s")):(column("rho_m")*1e3) with lines linetype i linewidth wide(i), \
  for [k = 1:runs] gap(k) with lines linestyle clearance # not i: `do for [i ...]` loses it in gnuplot 6.0
set size ratio -1
eval right_axis
eval down_axis
set parametric
set trange [0:2*pi]
from_x = 0.5 + 0.5*(left - right) + left; its_width = (1 - right - from_x + left)/in_a_row
do for [i = 1:runs] {
  row = (i - 1)/in_a_row; place = (i - 1) % in_a_row
  set lmargin at screen from_x + place*its_width; set rmargin at screen from_x + (place + 1)*its_width - left
  set tmargin at screen bottom + height - row*(orbit_height + 0.06)
  set bmargin at screen bottom + height - row*(orbit_height + 0.06) - orbit_height
  set ylabel (place ? "" : "x_a, mm (down)")
  set xlabel (row == orbit_rows - 1 ? "y_a, mm" : "")
  if (runs > 1) { set title shortened(name(i), 16) offset 0,-0.7 noenhanced font small }
  plot data(i, "x_a_m") using (column("y_a_m")*1e3):(column("x_a_m")*1e3) with lines linetype i linewidth 1, \
    gap(i)*cos(t), gap(i)*sin(t) with lines linestyle clearance
}
unset multiplot
