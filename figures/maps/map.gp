# A map, published and corrected equations side by side, or two values of another quantity. A script with the
# map's name, loaded before, defines the axes; the caller sets, besides what style.gp needs:
#   theory  what closed forms exceed, as map-theory writes it
#   note    what tolerance.sh says of the map
#   shows   outcome or force

if (!exists("rows")) { rows = 1; name_of_row(unused) = "" }
if (!exists("panels")) panels = "equations_varied"
if (!exists("duration")) duration = "0.5 s"
pins = exists("$cases")
name_of_panel(unused) = panels eq "equations_varied" ? words_of(strcol(panels)).name_of_row(0) : \
  sprintf(panel_format, column(panels))
if (!exists("x_unit")) x_unit = 1
if (!exists("y_unit")) y_unit = 1
if (!exists("x_log")) x_log = 0
if (!exists("y_log")) y_log = 0
along_x(v) = x_log ? log10(v) : v/x_unit
along_y(v) = y_log ? log10(v) : v/y_unit
if (rows == 2) { eval "set terminal ".square }

# What touches before the loss is refused, or stalls.
kN(force) = force eq "" ? NaN : real(force)/1e3

# gnuplot reads numbers much faster than a table with all its names.
stats data using (0) name "all" nooutput
panel = int(all_records - 1)/(2*rows)    # without the header row
nth(name) = int(sum [k = 1:all_columns] (columnhead(k) eq name ? k : 0))
stats data every ::0::0 using (result = nth(shows eq "outcome" ? "outcome" : "peak_force_to_rolling_N"), \
  x_column = nth(abscissa), y_column = nth(ordinate), 0) nooutput
rows_of(p) = sprintf("< awk -F, -v OFS=, '!/^#/ && n++ > %d { print $%d, $%d, $%d } n > %d { exit }' '%s'", \
  p*panel, result, x_column, y_column, (p + 1)*panel, data)
first_of(p) = sprintf("< awk '!/^#/ && (!n++ || n > %d) { print } n > %d { exit }' '%s'", 1 + p*panel, 1 + p*panel, data)

forms = shows eq "force" ? 6 : 5
load figures."/maps/lines.gp"
line(i) = line_style[i]." linecolor rgb law_tint"
white = "linecolor rgb '#ffffff' linewidth 3.5"    # beneath all lines
pin = "with points pointtype 7 pointsize 1 linecolor rgb event_tint, '' using 1:2 with points pointtype 7 pointsize 0.5 linecolor rgb '#ffffff'"
array seen[6] = [0, 0, 0, 0, 0, 0]
nth_word(n) = real(word(strcol(1), n))  # a table has no commas

set multiplot title "{/:Bold ".heading."}: ".(shows eq "outcome" ? "outcome within ".duration : "largest normal force"). \
  "\n{/*0.8 ".system(sprintf("cat '%s'", note))."}"
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
  its(unused) = outcome_code(strcol(1))
} else {
  eval force_palette
  set logscale cb
  darkest = 1000
  set cbrange [1:darkest]
  its(unused) = kN(strcol(1))
  greatest = real(system(sprintf("awk -F, '!/^#/ && n++ && $%d > most { most = $%d } END { print most/1e3 }' '%s'", \
    result, result, data)))
  if (greatest > darkest) { set cbtics 1,10,0.1*darkest; set cbtics add (sprintf("%d and more", darkest) darkest) }
}
found = system(sprintf("awk -F, '!/^#/ && n++ { print $%d == \"\" ? \"%s\" : %s }' '%s' | sort -u | tr '\n' ' '", \
  result, shows eq "outcome" ? "stalled" : "none", shows eq "outcome" ? sprintf("$%d", result) : "0", data))
top = 0.88; bottom = rows == 2 ? 0.2 : 0.33
height = (top - bottom)/rows
low = rows == 2 ? 0.03 : 0.06
do for [p = 0:2*rows - 1] {
  at_left = p % 2 == 0; at_bottom = p/2 == rows - 1
  set lmargin at screen at_left ? 0.095 : 0.56
  set rmargin at screen at_left ? 0.505 : 0.97
  set tmargin at screen top - height*(p/2) - 0.03
  set bmargin at screen top - height*(p/2 + 1) + 0.02
  stats first_of(p) using (titled = name_of_panel(0), column(abscissa)) nooutput
  set title titled offset 0,-0.6
  set format x (at_bottom ? numbers(x_log) : ""); set format y (at_left ? numbers(y_log) : "")
  set xlabel (at_bottom ? x_name : "") offset 0,0.4
  set ylabel (at_left ? y_name : "") offset 0,0
  if (shows eq "force" && p == 2*rows - 1) {
    set colorbox horizontal user origin screen 0.3, screen (rows == 2 ? 0.115 : 0.22) size screen 0.4, screen 0.018
    set cblabel "largest normal force, kN".(strstrt(" ".found, " none ") ? "; white: none" : "") offset 0,(rows == 2 ? 0.5 : 0.8)
  }
  edges = ""; drawn = ""
  do for [i = 1:forms] {
    its = sprintf("$line_%d_%d", p, i)
    eval sprintf("contours = sum [k = 1:|%s|] (%s[k][1:9] eq '# Contour')", its, its)
    if (contours) {
      along = sprintf(", %s using (nth_word(1)):(nth_word(2)) with lines ", its)
      edges = edges.along.white; drawn = drawn.along.line(i)
      seen[i] = 1
    }
  }
  if (pins) { drawn = drawn.", $cases using 1:2 ".pin }
  eval "plot rows_of(p) using (along_x($2)):(along_y($3)):(its(0)) with image ".(panel > 4096 || format eq "png" ? "" : "pixels").edges.drawn
}

# What the colours and lines mean.
unset title; unset border; unset tics; unset xlabel; unset ylabel; unset logscale
set xrange [0:1]; set yrange [0:1]
set lmargin at screen 0; set rmargin at screen 1; set bmargin at screen 0
lines = ""; colours = ""
do for [i = 1:forms] {
  if (seen[i]) { lines = lines.sprintf("keyentry with lines %s title '%s', ", line(i), line_words[i]) }
}
if (pins) { lines = lines."keyentry with points pointtype 6 pointsize 0.8 linewidth 1.6 linecolor rgb event_tint title 'cases of the paper', " }
do for [c = 0:6] {
  if (strstrt(" ".found, " ".outcome_name[c + 1]." ")) {
    colours = colours.sprintf("keyentry with boxes fillcolor rgb '%s' fillstyle solid border linecolor rgb event_tint title '%s', ", \
      outcome_tint[c + 1], outcome_words[c + 1].(outcome_name[c + 1] eq "freed" ? ": cannot reach the ring again" : \
      outcome_name[c + 1] eq "stalled" ? ", or no result" : ""))
  }
}
set key Left reverse spacing 1.05 noopaque font small
set tmargin at screen 0.4; unset colorbox
set key at screen 0.5, screen low center center samplen 4 maxrows (rows == 2 ? 2 : 3) width -6
if (strlen(lines)) { eval "plot ".lines."NaN notitle" }
set key at screen 0.5, screen (rows == 2 ? 0.1 : 0.19) center center samplen 1 maxrows 3 width -6
if (shows eq "outcome") { eval "plot ".colours."NaN notitle" }
unset multiplot
