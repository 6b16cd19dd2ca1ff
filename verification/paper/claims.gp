# A row for each number of the claims, in the paper's order: how far it is from what its rule allows, in both sets of
# equations. data is claims.csv, which report-numbers writes; its rows of readings that do not decide are not drawn.
clip = 4.0                                         # halves of the width of what is allowed
text = sprintf("DejaVu Sans,%g", 0.62*letters)
stats data using "row" nooutput
rows = STATS_max
eval "set terminal ".size(960, 12*rows + 72).sprintf(" font 'DejaVu Sans,%d' enhanced rounded", letters)
set margins 0, 0, 0, 0
set xrange [-13.6:16.6]; set yrange [rows + 1.2:-4.6]
unset border; unset tics; unset grid; unset key
shows(set) = strcol("decides") eq "yes" && strcol("equations") eq set
row_of(set) = shows(set) ? column("row") : NaN
glyph(verdict) = verdict eq "reproduced" ? "●" : verdict eq "refuted" ? "✖" : "◐"
within(x) = x < -clip ? -clip : x > clip ? clip : x
# The length of a line of draws: not drawn up to a tenth of a pixel, 0.003, where gnuplot 6 would draw a dot.
length(set) = shows(set) ? within(column("high")) - within(column("low")) : 0
side(set) = is_printed(set) ? -0.2 : 0.2           # as printed above corrected
percent(share) = share < 0.995 ? sprintf("%.0f %%", 100*share) : ""
new_heading(text) = !shows("published") || text eq last_heading ? "" : (last_heading = text, sprintf("{/:Bold %s}", text))
last_heading = ""

changed(text, k, old, new) = k ? text[:k - 1].new.text[k + strlen(old):] : text
symbol(text, old, new) = changed(text, strstrt(text, old), old, new)
in_units(text) = symbol(symbol(text, " um", " μm"), "kg m^2", "kg m²")

# Columns of text: where those of a set begin, after its verdict.
at(set) = is_printed(set) ? 4.9 : 10.9
do for [x = -4:4:2] {
  set arrow from x, 0.2 to x, rows + 0.7 nohead linecolor rgb "#d8d8d8" linewidth 0.6 back
  set label x == 0 ? "0" : sprintf("%+d", x) at x, -0.3 center font text
}
set object rectangle from -1, 0.2 to 1, rows + 0.7 fillcolor rgb "#e9eef0" fillstyle solid noborder behind
set label "number" at -13.2, -0.3 font text
set label "paper" at -7.6, -0.3 font text
set label "{/:Bold The numbers of the claims}   ● reproduced   ◐ within rounding   ✖ refuted      above as printed, below corrected" at -13.2, -3.9 font text
set label sprintf("Shaded: what the rule of the number allows; ±1 are its ends. Dots: at the inputs as printed. Lines: 5 to 95 %% of the draws (b). They end at ±%g; dots beyond are ◂ and ▸.", clip) \
  at -13.2, -2.9 font text
set label "draws: the share of (b) with such a value, if not all; of a statement, in which it is true. turned: by how many of 11 other rules, if any." at -13.2, -1.9 font text
do for [set in sets_of_claims = "published corrected"] {
  set label words_of(set) at at(set) - 0.15, -1.1 textcolor rgb tint_of(set) font text
  set label "value" at at(set) + 0.5, -0.3 textcolor rgb tint_of(set) font text
  set label "draws" at at(set) + 4.2, -0.3 right textcolor rgb tint_of(set) font text
  set label "turned" at at(set) + 5.7, -0.3 right textcolor rgb tint_of(set) font text
}
write = "with labels left noenhanced font text"
plot \
  for [set in sets_of_claims] data using (within(column("low"))):(length(set) > 0.003 ? row_of(set) + side(set) : NaN):(length(set)):(0) \
    with vectors nohead linecolor rgb lighter(tint_of(set), 0.35) linewidth 2.2, \
  for [set in sets_of_claims] data using (abs(column("distance")) <= clip ? column("distance") : NaN):(row_of(set) + side(set)) \
    with points pointtype 7 pointsize 0.38 linecolor rgb tint_of(set), \
  for [set in sets_of_claims] data using (column("distance") > clip ? clip + 0.25 : column("distance") < -clip ? -clip - 0.25 : NaN): \
    (row_of(set) + side(set)):(column("distance") > 0 ? "▸" : "◂") with labels center noenhanced font text textcolor rgb tint_of(set), \
  for [set in sets_of_claims] data using (at(set)):(row_of(set)):(glyph(strcol("verdict"))) with labels center noenhanced font text textcolor rgb tint_of(set), \
  for [set in sets_of_claims] data using (at(set) + 0.5):(row_of(set)):(in_units(strcol("value"))) @write textcolor rgb tint_of(set), \
  for [set in sets_of_claims] data using (at(set) + 4.2):(row_of(set)):(percent(column("share"))) with labels right noenhanced font text textcolor rgb tint_of(set), \
  for [set in sets_of_claims] data using (at(set) + 5.5):(row_of(set)):(column("turned_by") > 0 ? strcol("turned_by") : "") \
    with labels right noenhanced font text textcolor rgb tint_of(set), \
  data using (-13.2):(row_of("published")):(strcol("number")) @write, \
  data using (-7.6):(row_of("published")):(in_units(strcol("paper"))) @write textcolor rgb paper_tint, \
  data using (-13.4):(row_of("published") - 1):(new_heading(strcol("heading"))) with labels left enhanced font text
