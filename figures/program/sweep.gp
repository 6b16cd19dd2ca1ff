# A sweep: curves over one axis, maps over two, distributions of a sample. `rotor plot` sets, besides what style.gp needs:
#   heading; conditions in a number of lines; dimensions, the number of axes, and draws, the number at each of their points
#   for each axis its x_name, the places x_least and x_greatest of its ends, whether its values x_are_listed, and x_tics of a
#   list or of powers of ten; likewise for y
#   panels, their number, and if there are several their names panel0, panel1, ...
#   has_outcome; has_value, the result named result_name; its least and greatest value, in maps of means, or that it is_empty;
#   and how often each outcome was seen
# Each panel has a table of x, y, the outcome's code (in maps of draws the share that rolls), and the result.

data(p) = sprintf("panel%d.csv", p)
tint(c) = outcome_tint[c + 1]
edge_tint = "#606060"                              # around the lightest
dot = draws > 1 ? 0.25 : 0.5                       # its size
below = least < 0 ? 1.05*least : 0; above = greatest > 0 ? 1.05*greatest : below < 0 ? 0 : 1    # the limits of an axis

without_labels(tics) = (from = strstrt(tics, "'"), from == 0 ? tics : (until = strstrt(tics[from + 1:], "'") + from, \
  tics[:from]."'".without_labels(tics[until + 1:])))
name_beside(n, text, at) = sprintf("set label %d '%s' at screen %g, screen %g center rotate by 90 noenhanced", \
  n, text, n == 2 ? 0.02 : 0.98, at)
is_map = dimensions == 2
if (is_map && panels < 3) { eval "set terminal ".square }
rows = is_map ? has_outcome + has_value : has_value + (dimensions == 1 && has_outcome && (draws > 1 || !has_value))
top = 0.916 - 0.026*lines; bottom = has_outcome ? 0.19 : 0.11; left = is_map ? 0.13 : 0.1; right = is_map ? 0.84 : 0.965; gap = 0.05
height = (top - bottom)/rows; width = (right - left - gap*(panels - 1))/panels
set multiplot
set label 1 shortened(heading, 80) at screen 0.5,0.975 center noenhanced
set label 5 conditions at screen 0.5,0.938 center noenhanced font small
set tics front out
if (is_map) { unset grid }
unset key; unset colorbox
do for [row = 0:rows - 1] { do for [p = 0:panels - 1] {
  at_bottom = row == rows - 1
  of_outcome = is_map ? has_outcome && row == 0 : row == has_value
  set lmargin at screen left + p*(width + gap); set rmargin at screen left + p*(width + gap) + width
  set tmargin at screen top - row*height - (panels > 1 ? 0.03 : 0); set bmargin at screen top - (row + 1)*height + (at_bottom ? 0 : 0.03)
  if (row + p > 0) { unset label 1; unset label 5 }
  unset label 2; unset label 3; unset label 4
  if (is_empty && !(row == 0 && is_map && has_outcome)) { set label 4 "no point has this result" at graph 0.5,0.5 center front }
  middle = top - (row + 0.5)*height
  if (row == 0 && panels > 1) { set title value(sprintf("panel%d", p)) offset 0,-0.6 noenhanced } else { unset title }
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
    stats data(p) using (0) nooutput    # cells as rectangles, unless they are nearly as small as pixels
    eval "plot data(p) using 1:2:".(of_outcome ? 3 : 4)." with image ".(STATS_records > 4096 ? "" : "pixels")
    continue
  }
  if (dimensions == 1) {
    if (draws > 1) {    # bars at the points
      stats data(p) using 1 nooutput
      points = STATS_records/draws
      apart = points > 1 ? (x_greatest - x_least)/(points - 1) : 1
      set xrange [x_least - 0.6*apart:x_greatest + 0.6*apart]; set boxwidth 0.8*apart
      set style fill solid border rgb edge_tint; set grid noxtics
    } else {    # points at the ends are drawn in full
      if (x_are_listed) { set xtics autofreq }
      edge = x_greatest - x_least > 1e-6*abs(x_greatest) ? 0.015*(x_greatest - x_least) : \
        x_greatest == 0 ? 1 : 0.01*abs(x_greatest)    # of a single value
      set xrange [x_least - edge:x_greatest + edge]
    }
    if (of_outcome && draws == 1) {
      set yrange [0:1]; unset ytics
      plot for [c = 0:6] data(p) using 1:($3 == c ? 0.5 : NaN) with points pointtype 5 linecolor rgb tint(c), \
        data(p) using 1:(0.5) with points pointtype 4 linecolor rgb edge_tint linewidth 0.5
      continue
    }
    if (of_outcome) {    # stacked shares: of this outcome and of those with greater codes
      set yrange [0:1]
      eval "plot for [c = 0:6] data(p) using 1:($3 >= c ? 1.0/draws : 0) smooth frequency \
        with boxes fillcolor rgb tint(c)"
    } else {
      set yrange [below:above]
      plot data(p) using 1:(draws > 1 || x_are_listed ? NaN : $4) with lines linecolor rgb grey linewidth 0.8, \
        for [c = 0:6] data(p) using 1:($3 == c ? $4 : NaN) with points pointtype 7 pointsize dot linecolor rgb tint(c), \
        data(p) using 1:4 with points pointtype 6 pointsize dot linecolor rgb edge_tint linewidth 0.4
    }
    continue
  }
  # One distribution: the share in each of equal bins, with stacked outcomes; the same scale in all panels.
  bin = greatest > least ? (greatest - least)/50 : 1
  its(unused) = valid(4) ? $4 : NaN    # `smooth` would start anew after a number that is missing
  bin_of(v) = least + (v > least ? bin*floor((v - least)/bin*0.999999) : 0) + (greatest > least ? 0.5*bin : 0)
  share(c) = valid(4) && $3 >= c ? 1.0/draws : 0
  set xrange [least - bin:greatest + bin]; set yrange [0:1]
  if (p == 0) {
    highest = 0
    do for [other = 0:panels - 1] {
      set table $bins
      plot data(other) using (bin_of(its(0))):(share(0)) smooth frequency
      unset table
      set datafile separator whitespace
      stats $bins using (highest = $2 > highest ? $2 : highest, 0) nooutput
      set datafile separator comma
    }
  }
  set yrange [0:highest > 0 ? 1.05*highest : 1]
  set boxwidth bin
  set style fill solid border rgb edge_tint
  plot for [c = 0:6] data(p) using (bin_of(its(0))):(share(c)) smooth frequency with boxes fillcolor rgb tint(c)
} }

# What the colours mean.
unset title; unset border; unset tics; unset xlabel; unset label; unset colorbox
set xrange [0:1]; set yrange [0:1]
set lmargin at screen 0; set rmargin at screen 1; set bmargin at screen 0; set tmargin at screen 0.1
if (has_outcome && !(is_map && draws > 1)) {
  entries = ""
  do for [c = 0:6] {
    if (seen[c + 1] > 0) { entries = entries.sprintf("keyentry with points pointtype 5 pointsize 1.3 linecolor rgb '%s' title '%s%s', ", \
      tint(c), outcome_words[c + 1], dimensions || panels > 1 ? "" : sprintf(": %.3g %%", 100.0*seen[c + 1]/(sum [k = 1:7] seen[k]))) }
  }
  set key Left reverse spacing 1.05 noopaque font small at screen 0.5, screen 0.05 center center samplen 1 maxrows 2
  eval "plot ".entries."NaN notitle"
}
unset multiplot
