# A sweep: curves over one axis, maps over two, distributions of a sample. `rotor plot` sets, besides what style.gp needs:
#   data, the sweep's results, with the column result to draw if has_value, and the outcome if has_outcome; heading
#   dimensions, the number of axes, and draws, the number at each of their points
#   for each axis its column x_key, x_name, x_points, x_stride in rows, x_log, whether its values x_are_listed, and x_tics of a
#   list or of powers of ten; likewise for y
#   panels, the column of_panel that distinguishes them, and its values panel0, panel1, ...

spaced(text) = (at = strstrt(text, "_")) == 0 ? text : text[:at - 1]." ".spaced(text[at + 1:])
ends(text, with) = strlen(text) > strlen(with) && text[strlen(text) - strlen(with) + 1:] eq with
label_in(text, suffix, unit) = spaced(text[:strlen(text) - strlen(suffix)]).", ".unit
label_of(key) = ends(key, "_N") ? label_in(key, "_N", "kN") : ends(key, "_m") ? label_in(key, "_m", "mm") : \
  ends(key, "_s") ? label_in(key, "_s", "s") : ends(key, "_Hz") ? label_in(key, "_Hz", "Hz") : \
  ends(key, "_J") ? label_in(key, "_J", "J") : ends(key, "_kg") ? label_in(key, "_kg", "kg") : spaced(key)
unit = ends(result, "_N") ? 1e3 : ends(result, "_m") ? 1e-3 : 1
result_name = label_of(result)
panel_name(p) = spaced(ends(of_panel, "_varied") ? of_panel[:strlen(of_panel) - 7] : of_panel)." ".value(sprintf("panel%d", p))
is_in(p) = of_panel eq "" || strcol(of_panel) eq value(sprintf("panel%d", p))
in_panel(p, v) = is_in(p) ? v : NaN
its(unused) = strcol(result) eq "" ? NaN : column(result)/unit
code(unused) = outcome_code(strcol("outcome"))
array outcome_name[7] = ["no contact", "freed after contact", "bouncing", "sliding", "backward rolling", "undecided", \
  "stalled, or no result"]
tint(c) = c == 0 && dimensions < 2 ? "#b0b0b0" : outcome_tint[c + 1]
set datafile columnheaders
array seen[7] = [0, 0, 0, 0, 0, 0, 0]
stats data using (has_outcome ? seen[code(0) + 1] = seen[code(0) + 1] + 1 : 0, 0) name "all" nooutput
# A run without contact has no force, which is drawn as 0; other results are then missing. A refused point has no outcome.
without = result eq "peak_force_to_rolling_N" ? 0 : NaN
is_refused(unused) = has_outcome ? strcol("outcome") eq "" : 1
or_without(v) = v == v ? v : is_refused(0) ? NaN : without
# The draws of a point are adjacent; the mean of a single draw is the draw.
sum = 0; count = 0
last_draw(unused) = int(column(0)) % draws == draws - 1
mean(v) = (first = int(column(0)) % draws == 0, sum = (first ? 0. : sum) + (v == v ? v : 0), \
  count = (first ? 0 : count) + (v == v), last_draw(0) && count > 0 ? sum/count : NaN)
greatest = NaN; least = NaN    # of all that is drawn
if (has_value) {
  stats data using (v = dimensions == 2 ? mean(or_without(its(0))) : or_without(its(0)), least = v < least || least != least ? v : least, \
    greatest = v > greatest || greatest != greatest ? v : greatest, 0) nooutput
}
is_empty = has_value && least != least
if (least != least) { least = 0; greatest = 0 }
below = least < 0 ? 1.05*least : 0; above = greatest > 0 ? 1.05*greatest : below < 0 ? 0 : 1    # the limits of an axis

# The position of a row along an axis: its value, its logarithm, or its place in a list.
place(c, n, stride, is_log, is_listed) = is_listed ? int(column(0))/stride % n : is_log ? log10(column(c)) : column(c)
without_labels(tics) = (from = strstrt(tics, "'"), from == 0 ? tics : (until = strstrt(tics[from + 1:], "'") + from, \
  tics[:from]."'".without_labels(tics[until + 1:])))
name_beside(n, text, at) = sprintf("set label %d '%s' at screen %g, screen %g center rotate by 90 noenhanced", \
  n, text, n == 2 ? 0.02 : 0.98, at)
is_map = dimensions == 2
if (is_map && panels < 3) { eval "set terminal ".square }
rows = is_map ? has_outcome + has_value : has_value + (dimensions == 1 && has_outcome && (draws > 1 || !has_value))
top = 0.9; bottom = has_outcome ? 0.19 : 0.11; left = is_map ? 0.13 : 0.1; right = is_map ? 0.84 : 0.965; gap = 0.05
height = (top - bottom)/rows; width = (right - left - gap*(panels - 1))/panels
set multiplot
set label 1 shortened(heading, 80) at screen 0.5,0.965 center noenhanced
set tics front out
if (is_map) { unset grid }
unset key; unset colorbox
do for [row = 0:rows - 1] { do for [p = 0:panels - 1] {
  at_bottom = row == rows - 1
  of_outcome = is_map ? has_outcome && row == 0 : row == has_value
  set lmargin at screen left + p*(width + gap); set rmargin at screen left + p*(width + gap) + width
  set tmargin at screen top - row*height - (panels > 1 ? 0.03 : 0); set bmargin at screen top - (row + 1)*height + (at_bottom ? 0 : 0.03)
  if (row + p > 0) { unset label 1 }
  unset label 2; unset label 3; unset label 4
  if (is_empty && !(row == 0 && is_map && has_outcome)) { set label 4 "no point has this result" at graph 0.5,0.5 center front }
  middle = top - (row + 0.5)*height
  if (row == 0 && panels > 1) { set title panel_name(p) offset 0,-0.6 noenhanced } else { unset title }
  set xlabel (at_bottom ? (dimensions ? x_name : result_name) : "") offset 0,0.4 noenhanced
  if (p == 0) {
    eval name_beside(2, is_map ? y_name : of_outcome && draws == 1 ? "outcome" : of_outcome || !dimensions ? "share of the draws" : \
      result_name, middle)
  }
  set xrange [*:*] noextend; set yrange [*:*] noextend
  set format x (at_bottom ? "%g" : ""); set format y (p > 0 ? "" : "%g")
  if (is_map && panels > 1) { set xtics rotate by -45 }
  if (dimensions) { if (strlen(x_tics)) { eval "set xtics (".(at_bottom ? x_tics : without_labels(x_tics)).")" } }
  if (is_map) {
    if (strlen(y_tics)) { eval "set ytics (".(p == 0 ? y_tics : without_labels(y_tics)).")" }
    set palette maxcolors 0
    if (p == panels - 1) { set colorbox user origin screen right + 0.015, graph 0 size screen 0.02, graph 1 }
    if (p < panels - 1 || of_outcome && draws == 1) { unset colorbox } else {
      eval name_beside(3, of_outcome ? "share that rolls" : result_name.(draws > 1 ? ", mean" : ""), middle)
    }
    if (of_outcome && draws == 1) { eval outcome_palette }
    if (of_outcome && draws > 1) { eval share_palette }
    if (!of_outcome) { eval force_palette; set cbrange [below/1.05:above/1.05] }
    set table $cells separator comma
    plot data using (place(x_key, x_points, x_stride, x_log, x_are_listed)): \
      (place(y_key, y_points, y_stride, y_log, y_are_listed)): \
      (mean(!of_outcome ? or_without(its(0)) : draws == 1 ? code(0) : is_refused(0) ? NaN : code(0) == 4)) with table if (is_in(p) && last_draw(0))
    unset table
    unset datafile columnheaders
    plot $cells using 1:2:3 with image
    set datafile columnheaders
    continue
  }
  if (dimensions == 1) {    # draws at listed values stand side by side
    are_bars = draws > 1 && x_are_listed
    x_of(unused) = place(x_key, x_points, x_stride, x_log, are_bars)
    if (are_bars) {
      set xrange [-0.6:x_points - 0.4]; set boxwidth 0.8
      set style fill solid noborder; set grid noxtics
    } else {    # points at the ends are drawn in full
      if (x_are_listed) { set xtics autofreq }
      stats data using (x_of(0)) name "along" nooutput
      edge = along_max - along_min > 1e-6*abs(along_max) ? 0.015*(along_max - along_min) : \
        along_max == 0 ? 1 : 0.01*abs(along_max)    # of a single value
      set xrange [along_min - edge:along_max + edge]
    }
    if (of_outcome && draws == 1) {
      set yrange [0:1]; unset ytics
      plot for [c = 0:6] data using (in_panel(p, x_of(0))):(code(0) == c ? 0.5 : NaN) with points pointtype 5 linecolor rgb tint(c)
      continue
    }
    if (of_outcome) {    # stacked shares: of this outcome and of those with greater codes
      set yrange [0:1]
      eval "plot for [c = 0:6] data using (x_of(0)):(is_in(p) && code(0) >= c ? 1.0/draws : 0) smooth frequency \
        with ".(are_bars ? "boxes" : "filledcurves x1")." fillcolor rgb tint(c)"
    } else {
      set yrange [below:above]
      plot data using (in_panel(p, x_of(0))):(draws > 1 || x_are_listed ? NaN : or_without(its(0))) with lines linecolor rgb grey linewidth 0.8, \
        for [c = 0:6] data using (in_panel(p, x_of(0))):((has_outcome ? code(0) : 6) != c ? NaN : or_without(its(0))) \
        with points pointtype 7 pointsize (draws > 1 ? 0.25 : 0.5) linecolor rgb tint(c)
    }
    continue
  }
  # One distribution: the share in each of equal bins, with stacked outcomes; the same scale in all panels.
  bin = greatest > least ? (greatest - least)/50 : 1
  bin_of(v) = least + (v > least ? bin*floor((v - least)/bin*0.999999) : 0) + (greatest > least ? 0.5*bin : 0)
  share(v, p, c) = v == v && is_in(p) && !(has_outcome && code(0) < c) ? 1.0/draws : 0
  set xrange [least - bin:greatest + bin]; set yrange [0:1]
  if (p == 0) {
    highest = 0
    do for [other = 0:panels - 1] {
      set table $bins
      plot data using (bin_of(or_without(its(0)))):(share(or_without(its(0)), other, 0)) smooth frequency
      unset table
      unset datafile columnheaders; set datafile separator whitespace
      stats $bins using (highest = $2 > highest ? $2 : highest, 0) nooutput
      set datafile columnheaders; set datafile separator comma
    }
  }
  set yrange [0:highest > 0 ? 1.05*highest : 1]
  set boxwidth bin
  set style fill solid border rgb "#ffffff"
  plot for [c = 0:6] data using (bin_of(or_without(its(0)))):(share(or_without(its(0)), p, c)) \
    smooth frequency with boxes fillcolor rgb tint(c)
} }

# What the colours mean.
unset title; unset border; unset tics; unset xlabel; unset label; unset colorbox
set xrange [0:1]; set yrange [0:1]
set lmargin at screen 0; set rmargin at screen 1; set bmargin at screen 0; set tmargin at screen 0.1
if (has_outcome && !(is_map && draws > 1)) {
  entries = ""
  do for [c = 0:6] {
    if (seen[c + 1] > 0) { entries = entries.sprintf("keyentry with points pointtype 5 pointsize 1.3 linecolor rgb '%s' title '%s%s', ", \
      tint(c), outcome_name[c + 1], dimensions || panels > 1 ? "" : sprintf(": %.3g %%", 100.0*seen[c + 1]/all_records)) }
  }
  set key Left reverse spacing 1.05 noopaque font small at screen 0.5, screen 0.05 center center samplen 1 maxrows 2
  eval "plot ".entries."NaN notitle"
}
unset multiplot
