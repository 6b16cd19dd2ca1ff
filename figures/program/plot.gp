# Force, speed, displacement and orbit of any scene. `rotor plot` sets, besides what style.gp needs:
#   heading, conditions in one or more lines, speed_unit and its size per_Hz, and what it writes beside the data of a figure
# Each run has a data file for each panel in gnuplot's folder, named after the column that is drawn upwards.

runs = known_runs
gap(i) = 1e3*(of("stator_radius", i) - of("rotor_radius", i))
data(i, c) = sprintf("run%d-%s.csv", i, c)
greater(a, b) = a > b ? a : b
less(a, b) = a < b ? a : b
lines = 1 + sum [k = 1:strlen(conditions)] (conditions[k:k] eq "\n")
if (heading eq "") { heading = "Normal force, speed, displacement and orbit of O" }

# A run has the colour of its equations, or black if they are corrected in part; several of a set shades and dashes of it,
# the darker the larger the force.
peak(i) = (peak_N = of("peak_normal_force_N", i), peak_N == peak_N ? peak_N : 0)
earlier(i) = (of("equations", i) eq "mixed") + sum [k = 1:runs] (of("equations", k) eq of("equations", i) && \
  (k < i ? peak(k) >= peak(i) : peak(k) > peak(i)))
alike(i) = sum [k = 1:runs] (of("equations", k) eq of("equations", i))
tint(i) = of("equations", i) eq "mixed" ? event_tint : tint_of(of("equations", i))
array dashes[4] = ["solid", "(9,5)", "(3,3)", "(9,3,2,3)"]
do for [i = 1:runs] {
  set linetype i linecolor rgb lighter(tint(i), 0.7*earlier(i)/greater(3, alike(i))) linewidth 1.3
  eval sprintf("set linetype %d dashtype %s", i, dashes[earlier(i) % 4 + 1])
}
differ = sum [i = 1:runs] (of("equations", i) ne of("equations", 1))
says_set(set) = (set eq "mixed" ? "mixed equations" : short_of(set)).", at most "
in_N(force) = force < 1e3 ? sprintf("%.4g N", force) : force < 1e6 ? sprintf("%.4g kN", force/1e3) : sprintf("%.4g MN", force/1e6)
result(i) = (peak_N = of("peak_normal_force_N", i), outcome_words[outcome_code(of("outcome", i)) + 1]. \
  (peak_N == peak_N ? ", ".(differ ? says_set(of("equations", i)) : "largest force ").in_N(peak_N) : ""))

# Places are pixels from the upper left corner; widths of letters are those of png, the widest. The orbit of a single run
# is the fourth panel; of several that is their key, and the orbits are below, in rows.
wide = 960.; letter = 9.6
in_a_row = runs > 1 ? int(ceil(sqrt(1.5*runs))) : 1
orbit_rows = runs > 1 ? (runs + in_a_row - 1)/in_a_row : 0
cell = runs > 1 ? less(wide/in_a_row, 400) : 0
tall = 560. + cell*orbit_rows
eval "set terminal ".size(wide, tall).sprintf(" font 'DejaVu Sans,%d' enhanced rounded", letters)
top = 52 + 15*(lines + (runs == 1)); height = 0.5*(504 - top - 73)
panel(x0, x1, y0, y1) = sprintf("set lmargin at screen %g; set rmargin at screen %g; set tmargin at screen %g; set bmargin at screen %g", \
  x0/wide, x1/wide, 1 - y0/tall, 1 - y1/tall)
write(text, x, y, place) = sprintf("set label %s at screen %g,screen %g %s noenhanced", text, x/wide, 1 - y/tall, place)

# Axes end at tics, which are 1, 2 or 5 times a power of ten apart. Their labels have enough digits to differ. There
# are n steps, or fewer if labels would not fit. A constant curve has some space around it.
nice(x) = (power = 10.0**floor(log10(x)), (x < 1.001*power ? 1 : x < 2.001*power ? 2 : x < 5.001*power ? 5 : 10)*power)
between_tics(a, b) = (low = step*floor(a/step + 1e-6), high = step*ceil(b/step - 1e-6), \
  letters_of = greater(strlen(sprintf(form, low)), strlen(sprintf(form, high))))
fit(a, b, n, room) = (step = nice((b - a)/n), form = sprintf("%%.%df", step < 1 ? ceil(-log10(step) - 1e-6) : 0), \
  between_tics(a, b), n > 1 && (high - low)/step*(letters_of + 1)*letter > room ? fit(a, b, n - 1, room) : letters_of)
changes(a, b) = b - a > 1e-12*greater(abs(a), abs(b))
around(a) = a == 0 ? 1 : 0.01*abs(a)
show(a, b, n, room) = changes(a, b) ? fit(a, b, n, room) : fit(a - around(a), b + around(a), n, room)
axis(c, from, to) = sprintf("set %srange [%.17g:%.17g]; set %stics %.17g; set format %s '%s'", \
  c, from - 1e-5*(to - from), to + 1e-5*(to - from), c, step, c, form)    # rounding must cut nothing off

# The limits of all runs' data and clearances, and an arrow where each orbit ends.
array ending[runs]
keep(x, y) = (!places || x != x_2 || y != y_2 ? (places = places + 1, x_1 = x_2, y_1 = y_2, x_2 = x, y_2 = y) : 0, x)
do for [i = 1:runs] {
  do for [c in "time_s normal_force_N speed_Hz rho_m x_a_m y_a_m"] {
    stats data(i, c eq "time_s" ? "speed_Hz" : c eq "y_a_m" ? "x_a_m" : c) using (column(c)) name "its" nooutput
    eval sprintf("least_%s = i > 1 ? less(least_%s, its_min) : its_min", c, c)
    eval sprintf("most_%s = i > 1 ? greater(most_%s, its_max) : its_max", c, c)
  }
  places = 0; x_2 = 0; y_2 = 0
  stats data(i, "x_a_m") using (keep(1e3*column("x_a_m"), 1e3*column("y_a_m"))) nooutput
  ending[i] = places > 1 ? sprintf("set arrow from %.17g,%.17g to %.17g,%.17g arrowstyle 5 front", y_1, x_1, y_2, x_2) : ""
  widest_gap = i > 1 ? greater(widest_gap, gap(i)) : gap(i)
  least_gap = i > 1 ? less(least_gap, gap(i)) : gap(i)
}
widest = show(least_normal_force_N/1e3, most_normal_force_N/1e3, 5, wide); force_axis = axis("y", low, high)
widest = greater(widest, show(per_Hz*least_speed_Hz, per_Hz*most_speed_Hz, 5, wide)); speed_axis = axis("y", low, high)
rho_min = less(1e3*least_rho_m, 0.98*least_gap); rho_max = greater(1e3*most_rho_m, 1.02*widest_gap)
widest = greater(widest, show(rho_min, rho_max, 5, wide)); rho_axis = axis("y", low, high)
down_min = less(1e3*least_x_a_m, -widest_gap); down_max = greater(1e3*most_x_a_m, widest_gap)
right_min = less(1e3*least_y_a_m, -widest_gap); right_max = greater(1e3*most_y_a_m, widest_gap)
half = 0.5*greater(down_max - down_min, right_max - right_min)
left = 53 + letter*widest
side = runs > 1 ? cell - 95 : height               # of an orbit
void = fit(-half, half, 5, 0.9*side)               # as wide as high
down_letters = between_tics(down_min, down_max); down_axis = axis("y", high, low)
void = between_tics(right_min, right_max); right_axis = axis("x", low, high)
time_letters = show(least_time_s, most_time_s, 8, 0.44*wide - left); right = 10 + 0.5*letter*time_letters
if (changes(least_time_s, most_time_s)) { low = least_time_s; high = most_time_s }

set multiplot
unset key
eval write("shortened(heading, 80)", 0.5*wide, 17, "center")
eval write("conditions", 0.5*wide, 39, "center font small")
if (runs == 1) { eval write("result(1).'; dotted: clearance'", 0.5*wide, 39 + 15*lines, "center font small") } else {
  most = int(height/20); named = runs > most ? most - 1 : runs
  do for [k = 1:named + 1] {
    says = k <= named ? shortened(greek(of("run", k)), 24).": ".result(k) : \
      (named < runs ? sprintf("and %d more runs; ", runs - named) : "")."dotted: clearance"
    y = top + height + 73 + 20*(k - 1)
    eval write("says", 0.5*wide + (k <= named ? 65 : 20), y, "font small")
    if (k <= named) { set arrow from screen 0.5 + 20/wide,screen 1 - y/tall rto screen 38/wide,screen 0 nohead linetype k }
  }
}
eval axis("x", low, high)
set xlabel "t, s" offset 0,0.4
set ylabel "F_n, kN" offset -0.5,0
eval force_axis
eval panel(left, 0.5*wide - right, top, top + height)
if (!changes(least_normal_force_N, most_normal_force_N)) { unset ytics; set label "no contact in this time" at graph 0.5,graph 0.5 center offset 0,0.7 }
plot for [i = runs:1:-1] data(i, "normal_force_N") using (column("time_s")):(column("normal_force_N")/1e3) with lines linetype i
unset label; unset arrow
set ylabel "f, ".speed_unit
eval speed_axis
eval panel(0.5*wide + left, wide - right, top, top + height)
plot for [i = runs:1:-1] data(i, "speed_Hz") using (column("time_s")):(per_Hz*column("speed_Hz")) with lines linetype i
set ylabel "ρ, mm"
eval rho_axis
eval panel(left, 0.5*wide - right, top + height + 73, top + 2*height + 73)
plot for [i = runs:1:-1] data(i, "rho_m") using (column("time_s")):(column("rho_m")*1e3) with lines linetype i, \
  for [k = 1:runs] gap(k) with lines linestyle clearance # not i: `do for [i ...]` loses it in gnuplot 6.0
set size ratio -1
eval right_axis
eval down_axis
set parametric
set trange [0:2*pi]
do for [i = 1:runs] {
  x = runs > 1 ? 75 + (i - 1) % in_a_row*cell : 0.5*wide + left
  y = runs > 1 ? 590 + (i - 1)/in_a_row*cell : top + height + 73
  set ylabel "x_a, mm (down)"
  set xlabel "y_a, mm"
  if (runs > 1) { set title shortened(greek(of("run", i)), int(less(36, cell/8.8))) offset 0,-0.7 noenhanced font small textcolor linetype i }
  eval panel(x, x + (runs > 1 ? side : 0.5*wide - right - left), y, y + side)
  unset arrow
  eval ending[i]
  plot data(i, "x_a_m") using (column("y_a_m")*1e3):(column("x_a_m")*1e3) with lines linetype i dashtype solid, \
    gap(i)*cos(t), gap(i)*sin(t) with lines linestyle clearance
}
unset multiplot
