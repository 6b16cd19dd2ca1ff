# Maps of a sweep over two quantities, and the results beside each other that are shown of them. `rotor plot` sets, besides
# what style.gp needs:
#   heading; conditions in one or more lines; panels and their names, panel1, ...; columns, and of each, by its number, label1,
#   low1 and high1 of its numbers, log1, gaps1 (whether some are empty) and of_outcome1; found, the codes of outcomes
#   x_name, y_name, x_unit, y_unit, x_log and y_log of the axes; cells, of a panel
# and writes for each panel panelN.csv: the place along both axes, and the columns, outcomes as codes. For the maps of the
# repository `make maps` adds:
#   folder  where these files are
#   theory  what closed forms exceed, as map-theory writes it
#   note    what tolerance.sh says of the map
#   $cases  of the paper, or $border, a line, and border_words; from a script with the map's name

if (!exists("folder")) folder = "."
data(p) = sprintf("%s/panel%d.csv", folder, p)
along_x(v) = x_log ? log10(v/x_unit) : v/x_unit
along_y(v) = y_log ? log10(v/y_unit) : v/y_unit
of_outcome(c) = value(sprintf("of_outcome%d", c))
pins = exists("$cases"); bordered = exists("$border")
forms = 0
if (exists("theory")) {
  forms = columns == 1 && of_outcome(1) ? 5 : 6
  load figures."/maps/lines.gp"
}
line(i) = line_style[i]." linecolor rgb law_tint"
white = "linecolor rgb '#ffffff' linewidth 3.5"    # beneath all lines
pin = "with points pointtype 7 pointsize 1 linecolor rgb event_tint, '' using 1:2 with points pointtype 7 pointsize 0.5 linecolor rgb '#ffffff'"
array seen[6] = [0, 0, 0, 0, 0, 0]
nth_word(n) = real(word(strcol(1), n))  # a table has no commas

# Places are pixels from the upper left corner. Two pictures are in a row, those of a panel or one of each panel.
pictures = panels*columns
rows = (pictures + 1)/2
lines = 1 + exists("note") + sum [k = 1:strlen(conditions)] (conditions[k:k] eq "\n")
wide = rows > 1 ? 760. : 960.
row = rows > 1 ? 255. : 300.
top = 40. + 16*lines; between = 38.; bottom = 130. + 45*(forms > 0 || pins || bordered)
tall = top + rows*(row + between) + 20 + bottom
eval "set terminal ".size(wide, tall).sprintf(" font 'DejaVu Sans,%d' enhanced rounded", letters)
write(text, x, y) = sprintf("set label %s at screen %g,screen %g center noenhanced", text, x/wide, 1 - y/tall)

set multiplot
eval write("shortened(heading, 80)", 0.5*wide, 17)
eval write("conditions", 0.5*wide, 38)." font small"
if (exists("note")) { set label system(sprintf("cat '%s'", note)) at screen 0.5,screen 1 - (22. + 16*lines)/tall center font small }
set tics front out
unset grid
unset colorbox
unset key
set xrange [*:*] noextend; set yrange [*:*] noextend
numbers(is_log) = is_log ? "10^{%g}" : "%g"
if (x_log) { set xtics 1 }
if (y_log) { set ytics 1 }
from_of(c) = value(sprintf("low%d", c)); until_of(c) = value(sprintf("high%d", c))
decade(x) = 10.0**floor(log10(x) + 1e-9)
do for [n = 0:pictures - 1] {
  p = n/columns; c = n % columns + 1
  at_left = n % 2 == 0; at_bottom = n + 2 >= pictures
  left = pictures == 1 ? 0.25 : at_left ? 0.1 : 0.56
  set lmargin at screen left
  set rmargin at screen left + (pictures == 1 ? 0.5 : 0.4)
  set tmargin at screen 1 - (top + (n/2)*(row + between) + 30)/tall
  set bmargin at screen 1 - (top + (n/2)*(row + between) + 30 + row)/tall
  named = value(sprintf("panel%d", p + 1))
  set title (named ne "" ? named : of_outcome(c) ? "outcome" : value(sprintf("label%d", c))) offset 0,-0.6 noenhanced
  set format x (at_bottom ? numbers(x_log) : ""); set format y (at_left ? numbers(y_log) : "")
  set xlabel (at_bottom ? x_name : "") offset 0,0.4 noenhanced
  set ylabel (at_left ? y_name : "") offset 0.5,0 noenhanced
  unset logscale cb; unset colorbox
  if (of_outcome(c)) { eval outcome_palette } else {
    set palette maxcolors 0
    eval force_palette
    low = from_of(c); high = until_of(c)
    if (low != low) { low = 0; high = 1 }
    if (low == high) { low = low - 0.5; high = high + 0.5 }
    if (value(sprintf("log%d", c))) {
      # At most three decades, of which the lowest colour also stands for what is below.
      high = decade(high) < high ? 10*decade(high) : high; low = decade(low) < high/1e3 ? high/1e3 : decade(low)
      set logscale cb
    }
    set cbrange [low:high]
    if (n + columns >= pictures) {
      set colorbox horizontal user origin screen (columns == 1 ? 0.3 : left), screen (bottom - 62)/tall size screen 0.4, screen 10/tall
      set cblabel value(sprintf("label%d", c)).(value(sprintf("gaps%d", c)) ? "; white: none" : "") offset 0,0.6 noenhanced
    }
  }
  edges = ""; drawn = ""
  do for [i = 1:forms] {
    its = sprintf("$line_%d_%d", p, i)
    eval sprintf("contours = sum [k = 1:|%s|] (%s[k][1:9] eq '# Contour')", its, its)
    if (contours && (i < 6 || !of_outcome(c))) {
      along = sprintf(", %s using (nth_word(1)):(nth_word(2)) with lines ", its)
      edges = edges.along.white; drawn = drawn.along.line(i)
      seen[i] = 1
    }
  }
  if (bordered) { edges = edges.", $border using 1:2 with lines ".white; drawn = drawn.", $border using 1:2 with lines linestyle clearance" }
  if (pins) { drawn = drawn.", $cases using 1:2 ".pin }
  eval "plot data(p + 1) using 1:2:(column(2 + c)) with image ".(cells > 4096 || format eq "png" ? "" : "pixels").edges.drawn
  unset label
}

# What the colours and lines mean.
unset title; unset border; unset tics; unset xlabel; unset ylabel; unset logscale; unset colorbox
set xrange [0:1]; set yrange [0:1]
set lmargin at screen 0; set rmargin at screen 1; set bmargin at screen 0; set tmargin at screen bottom/tall
meaning = ""; colours = ""
do for [i = 1:forms] {
  if (seen[i]) { meaning = meaning.sprintf("keyentry with lines %s title '%s', ", line(i), line_words[i]) }
}
if (bordered) { meaning = meaning."keyentry with lines linestyle clearance title border_words, " }
if (pins) { meaning = meaning."keyentry with points pointtype 6 pointsize 0.8 linewidth 1.6 linecolor rgb event_tint title 'cases of the paper', " }
do for [k in found] {
  name = outcome_name[int(k) + 1]
  colours = colours.sprintf("keyentry with boxes fillcolor rgb '%s' fillstyle solid border linecolor rgb event_tint title '%s', ", \
    outcome_tint[int(k) + 1], outcome_words[int(k) + 1].(name eq "freed" ? ": cannot reach the ring again" : ""))
}
set key Left reverse spacing 1.05 noopaque font small
set key at screen 0.5, screen 30/tall center center samplen 4 maxrows 3 width -6
if (strlen(meaning)) { eval "plot ".meaning."NaN notitle" }
set key at screen (columns == 1 ? 0.5 : 0.04), screen (bottom - 62)/tall samplen 1 maxrows 3
if (columns == 1) { set key center center width -6 } else { set key left center width 0 }
if (strlen(colours) && (sum [c = 1:columns] of_outcome(c))) { eval "plot ".colours."NaN notitle" }
unset multiplot
