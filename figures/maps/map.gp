# A map, published and consistent equations side by side. A script with the map's name, loaded before, defines
# the axes; the caller sets, besides what style.gp needs:
#   theory  closed forms at the same points
#   shows   outcome or force

if (!exists("rows")) { rows = 1; name_of_row(unused) = "" }
name_of_panel(unused) = strcol("equations_varied")." equations".name_of_row(0)
if (!exists("x_unit")) x_unit = 1
if (!exists("y_unit")) y_unit = 1
if (!exists("x_log")) x_log = 0
if (!exists("y_log")) y_log = 0
along_x(v) = x_log ? log10(v) : v/x_unit
along_y(v) = y_log ? log10(v) : v/y_unit
if (rows == 2) { eval "set terminal ".square }

# What touches or stalls before the loss is refused, or stalls.
classes = |outcome_tint|
array name[classes] = ["no contact", "freed after contact", "bouncing after 0.5 s", "sliding after 0.5 s", \
  "backward rolling", "undecided after 0.5 s", "touches or stalls before the loss"]
kN(force) = force eq "" ? NaN : real(force)/1e3

stats data using (1) nooutput name "all"
panel = int(all_records)/(2*rows)
stats theory using (1) nooutput name "closed"
closed_scan = int(sqrt(closed_records/(2*rows)) + 0.5)

# Lines on which a closed form equals the quantity it is compared with: $closed_P_I of panel P and form I.
forms = 6
array form[forms] = ["greatest_m", "bound_m", "steady_m", "synchronous_friction", "rebound_friction", "peak_force_N"]
array meaning[forms] = ["closed forms: border of contact", "limit of possible contact", \
  "steady response reaches the ring", "limit of lasting forward rub", \
  "limit of backward whirl by rebounds", "largest force of 300 kN"]
array line[forms] = ["linecolor rgb black linewidth 1.6", "linecolor rgb black linewidth 1.2 dashtype (5,4)", \
  "linecolor rgb blue linewidth 1.6 dashtype (2,2)", "linecolor rgb '#7a0177' linewidth 1.8 dashtype (8,3)", \
  "linecolor rgb '#006d2c' linewidth 1.8 dashtype (8,3,2,3)", "linecolor rgb '#30c0c0' linewidth 1.8"]
nth(name) = int(system(sprintf("sed -n '/^[^#]/{p;q}' '%s' | tr , '\\n' | grep -nx %s | cut -d: -f1", theory, name)))
u = nth(abscissa); v = nth(ordinate); mu = nth("mu"); gap = nth("clearance_m")
array of[forms]
do for [i = 1:forms] { of[i] = nth(form[i]) }
excess(i) = i == 6 ? (shows eq "force" ? column(of[i])/3e5 - 1 : 1) : i > 3 ? (column(of[i]) > 1 ? 1 : column(of[i])) - column(mu) : column(of[i])/column(gap) - 1
set contour base; unset surface; set cntrparam levels discrete 0; set zrange [-1000:1000]
do for [p = 0:2*rows - 1] { do for [i = 1:forms] {
  eval sprintf("set table $closed_%d_%d", p, i)
  splot theory every :::p*closed_scan + 1::(p + 1)*closed_scan using (along_x(column(u))):(along_y(column(v))):(excess(i))
  unset table
} }
unset contour; set surface

nth_word(n) = real(word(strcol(1), n))    # gnuplot's tables have no commas
array seen[forms] = [0, 0, 0, 0, 0, 0]

set multiplot title "{/:Bold ".heading."}: ".(shows eq "outcome" ? "outcome" : "largest normal force")
set tics front out
unset grid
unset colorbox
unset key
set xrange [*:*] noextend; set yrange [*:*] noextend
numbers(is_log) = is_log ? "10^{%g}" : "%g"
if (x_log) { set xtics 1 }
if (y_log) { set ytics 1 }
if (shows eq "outcome") {
  eval outcome_palette
  value = "outcome_code(strcol('outcome'))"
} else {
  eval force_palette
  set logscale cb
  darkest = 1000; greatest = 0
  set cbrange [1:darkest]
  value = "kN(strcol('peak_force_to_rolling_N'))"
  eval sprintf("stats data using (force = %s, greatest = force > greatest ? force : greatest, column('%s')) nooutput", \
    value, abscissa)
  if (greatest > darkest) { set cbtics 1,10,0.1*darkest; set cbtics add (sprintf("%d and more", darkest) darkest) }
}
top = 0.9; bottom = rows == 2 ? 0.19 : 0.28
height = (top - bottom)/rows
low = rows == 2 ? 0.025 : 0.035
do for [p = 0:2*rows - 1] {
  at_left = p % 2 == 0; at_bottom = p/2 == rows - 1
  set lmargin at screen at_left ? 0.09 : 0.555
  set rmargin at screen at_left ? 0.515 : 0.98
  set tmargin at screen top - height*(p/2) - 0.03
  set bmargin at screen top - height*(p/2 + 1) + 0.02
  eval sprintf("stats data every ::p*panel::p*panel using (titled = name_of_panel(0), column('%s')) nooutput", abscissa)
  set title titled offset 0,-0.6
  set format x (at_bottom ? numbers(x_log) : ""); set format y (at_left ? numbers(y_log) : "")
  set xlabel (at_bottom ? x_name : "") offset 0,0.4
  set ylabel (at_left ? y_name : "") offset 0.5,0
  if (shows eq "force" && p == 2*rows - 1) {
    set colorbox horizontal user origin screen 0.3, screen (rows == 2 ? 0.105 : 0.175) size screen 0.4, screen 0.018
    set cblabel "largest normal force, kN; white: no contact, or contact before the loss" offset 0,0.8
  }
  drawn = ""
  do for [i = 1:forms] {
    eval sprintf("lines = |$closed_%d_%d|", p, i)
    if (lines > 5) {
      drawn = drawn.sprintf(", $closed_%d_%d using (nth_word(1)):(nth_word(2)) with lines %s", p, i, line[i])
      seen[i] = 1
    }
  }
  eval sprintf("plot data every ::p*panel::(p + 1)*panel - 1 using (along_x(column('%s'))):(along_y(column('%s'))):(%s) with image", \
    abscissa, ordinate, value).drawn
}

# What the colours and lines mean.
unset title; unset border; unset tics; unset xlabel; unset ylabel; unset logscale
set xrange [0:1]; set yrange [0:1]
set lmargin at screen 0; set rmargin at screen 1; set bmargin at screen 0
lines = ""; colours = ""
do for [i = 1:forms] {
  if (seen[i]) { lines = lines.sprintf("keyentry with lines %s title '%s', ", line[i], meaning[i]) }
}
do for [i = 1:classes] {
  colours = colours.sprintf("keyentry with points pointtype 5 pointsize 1.3 linecolor rgb '%s' title '%s', ", outcome_tint[i], name[i])
}
set key Left reverse spacing 1.05 noopaque font small
set tmargin at screen 0.4; unset colorbox
set key at screen 0.5, screen low center center samplen 2.5 maxrows (rows == 2 ? 1 : 2) width -6
if (strlen(lines)) { eval "plot ".lines."NaN notitle" }
set key at screen 0.5, screen (rows == 2 ? 0.09 : 0.12) center center samplen 1 maxrows 3 width -6
if (shows eq "outcome") { eval "plot ".colours."NaN notitle" }
unset multiplot
