# Results over one quantity, or of a sample as histograms. `rotor plot` sets, besides what style.gp needs:
#   heading; conditions in one or more lines; panels and their names, panel1, ...; columns, and of each, by its number, label1,
#   low1 and high1 of its numbers, log1, gaps1 (whether some are empty) and of_outcome1; found, the codes of outcomes; is_sample
#   over a quantity: x_name, x_log, x_low, x_high; panelN.csv has the quantity, the code, each column and whether it is empty;
#   sections, whether sectionN.csv has the quantity and x_a once a turn, unless turnsN is 0, and low0 and high0 of that
#   of a sample: barsN-C.csv has from, to, bottom and top of each bar in percent, and the code; emptyN_C is the percentage
#   without a value, tallestC that of the tallest bar
# In a code, -1 stands for a point without an outcome. Rows of panels are columns of the results.

lines = 1 + sum [k = 1:strlen(conditions)] (conditions[k:k] eq "\n")
wide = panels > 3 ? 320.*panels : 960.
if (is_sample) { sections = 0 }
label0 = "x_a once a turn, mm"; log0 = 0
rows = columns + sections
row = rows > 1 ? 210. : 340.
between = 84.
top = 78 + 15*lines + 22*(panels > 1); bottom = 70.
tall = top + rows*(row + between) - between + 40 + bottom
eval "set terminal ".size(wide, tall).sprintf(" font 'DejaVu Sans,%d' enhanced rounded", letters)
write(text, x, y, place) = sprintf("set label %s at screen %g,screen %g %s noenhanced", text, x/wide, 1 - y/tall, place)
tint_of_code(code) = code < 0 ? "#8a8a8a" : outcome_tint[code + 1]
codes = found eq "" ? "-1" : found

# Numbers that do not differ have some space around them.
around(a) = a == 0 ? 1 : 0.05*abs(a)
from_of(c) = value(sprintf("low%d", c)); until_of(c) = value(sprintf("high%d", c))
has_numbers(c) = from_of(c) == from_of(c)
has_long_tics(c) = has_numbers(c) && !is_sample && (abs(from_of(c)) > 9999 || abs(until_of(c)) > 9999)
left = 66. + 24*((sum [c = 1 - sections:columns] has_long_tics(c)) > 0); gap = 28.
side = (wide - left - 34 - (panels - 1)*gap)/panels
margin(c) = from_of(c) == until_of(c) ? around(from_of(c)) : 0.04*(until_of(c) - from_of(c))
is_log(c) = value(sprintf("log%d", c))
range_of(c) = !has_numbers(c) ? "[0:1]" : is_log(c) ? sprintf("[%.9g:%.9g]", 0.8*from_of(c), 1.25*until_of(c)) : \
  sprintf("[%.9g:%.9g]", from_of(c) - margin(c), until_of(c) + margin(c))

set multiplot
unset key
eval write("shortened(heading, 80)", 0.5*wide, 18, "center")
eval write("conditions", 0.5*wide, 41, "center font small")
do for [p = 1:panels] {
  if (panels > 1) { eval write(sprintf("shortened(panel%d, 40)", p), left + (p - 0.5)*side + (p - 1)*gap, top - 34, "center") }
}
do for [c = 1 - sections:columns] {
  above = top + (c - 1 + sections)*(row + between)
  do for [p = 1:panels] {
    set lmargin at screen (left + (p - 1)*(side + gap))/wide
    set rmargin at screen (left + (p - 1)*(side + gap) + side)/wide
    set tmargin at screen 1 - above/tall
    set bmargin at screen 1 - (above + row)/tall
    unset logscale; set xtics autofreq norotate; set format "%g"
    if (p > 1) { set format y "" }
    if (is_sample) {
      data = sprintf("bars%d-%d.csv", p, c)
      void = value(sprintf("empty%d_%d", p, c))
      set xlabel value(sprintf("label%d", c)).(void > 0 ? sprintf("; none: %.3g %%", void) : "") offset 0,0.4 noenhanced
      if (p == 1) { set label 98 "draws, %" at graph 0,graph 1 left offset 0,0.7 }
      tallest = value(sprintf("tallest%d", c))
      set yrange [0:(tallest > 0 ? 1.05*tallest : 1)]
      if (value(sprintf("of_outcome%d", c))) {
        unset xlabel
        last = strstrt(found, "7") ? 7 : 6          # no result
        set xrange [-0.5:last + 0.5]; set xtics scale 0
        set for [k = 0:last] xtics add (outcome_words[k + 1] k)
        if (panels > 1) { set xtics rotate by -25 }
      } else {
        eval "set xrange ".range_of(c)
        if (is_log(c)) { set logscale x }
      }
      plot data using (0.5*($1 + $2)):4:1:2:3:4:(real("0x".tint_of_code(int($5))[2:7])) with boxxyerror fillstyle solid border linecolor rgb event_tint \
        linewidth 0.4 fillcolor rgb variable, NaN
    } else {
      data = sprintf("panel%d.csv", p)
      set xlabel (c == columns ? x_name : "") offset 0,0.4 noenhanced
      if (p == 1) { set label 98 value(sprintf("label%d", c)) at graph 0,graph 1 left offset 0,0.7 noenhanced }
      if (x_log) { set logscale x; set xrange [x_low/1.05:x_high*1.05] } else { set xrange [x_low - 0.02*(x_high - x_low):x_high + 0.02*(x_high - x_low)] }
      eval "set yrange ".range_of(c)
      if (is_log(c)) { set logscale y }
      set y2range [0:1]
      its(code, i) = $2 == code ? column(2 + i) : NaN
      lacks(code, i) = $2 == code && column(2 + columns + i) == 1 ? 0.025 : NaN
      if (c == 0) {
        if (value(sprintf("turns%d", p))) {
          plot sprintf("section%d.csv", p) using 1:2 with points pointtype 7 pointsize 0.3 linecolor rgb event_tint
        } else { plot NaN }
      } else {
        plot for [k in codes] data using 1:(lacks(int(k), c)) axes x1y2 with points pointtype 5 pointsize 0.55 linecolor rgb tint_of_code(int(k)), \
          data using 1:(column(2 + c)) with points pointtype 7 pointsize 0.75 linecolor rgb event_tint, \
          for [k in codes] data using 1:(its(int(k), c)) with points pointtype 7 pointsize 0.6 linecolor rgb tint_of_code(int(k))
      }
    }
    unset label
  }
}

# What the colours mean.
unset border; unset tics; unset xlabel; unset ylabel; unset logscale; unset grid
set xrange [0:1]; set yrange [0:1]
set lmargin at screen 0; set rmargin at screen 1; set bmargin at screen 0; set tmargin at screen bottom/tall
set key at screen 0.5, screen 0.42*bottom/tall center center Left reverse samplen 1 maxrows 2 noopaque font small
gaps = is_sample ? 0 : sum [c = 1:columns] value(sprintf("gaps%d", c))
entries = ""
do for [k in (found eq "" ? "" : found)] {
  entries = entries.sprintf("keyentry with boxes fillcolor rgb '%s' fillstyle solid border linecolor rgb event_tint title '%s', ", tint_of_code(int(k)), outcome_words[int(k) + 1])
}
if (gaps) { entries = entries."keyentry with points pointtype 5 pointsize 0.7 linecolor rgb paper_tint title 'at the lower edge: no value', " }
if (strlen(entries)) { eval "plot ".entries."NaN notitle" }
unset multiplot
