# The look of all figures. The caller sets, with gnuplot's -e:
#   output    the picture
#   format    svg, pdf or png
#   data      a CSV file, columns addressed by name; of a figure of the paper instead
#   data_published, data_consistent  its files in each set of equations, or in one of them
# The picture is wide; for a square one a script has: eval "set terminal ".square

set datafile separator comma
set encoding utf8

# Terminals. Sizes are in pixels for svg and png, and the same proportions for pdf.
wide_svg = "size 960,560 font 'DejaVu Sans,14' background 'white' enhanced rounded linewidth 1"
square_svg = "size 760,800 font 'DejaVu Sans,14' background 'white' enhanced rounded linewidth 1"
wide_pdf = "size 16cm,9.33cm font 'DejaVu Sans,8' enhanced rounded linewidth 0.7"
square_pdf = "size 12.7cm,13.3cm font 'DejaVu Sans,8' enhanced rounded linewidth 0.7"
if (format eq "svg") { wide = "svg ".wide_svg; square = "svg ".square_svg }
if (format eq "png") { wide = "pngcairo size 1920,1120 font 'DejaVu Sans,11' fontscale 2 pointscale 2 enhanced rounded linewidth 2.4"
                       square = "pngcairo size 1520,1600 font 'DejaVu Sans,11' fontscale 2 pointscale 2 enhanced rounded linewidth 2.4" }
if (format eq "pdf") { wide = "pdfcairo ".wide_pdf; square = "pdfcairo ".square_pdf }
eval "set terminal ".wide
small = sprintf(",%g", 0.8*(format eq "svg" ? 14 : format eq "png" ? 11 : 8))    # a font for long keys
set output output

# Colours that colour-blind readers can distinguish. What a run of ours shows has the colour of its equations, in all
# figures and on the page; the paper's values are grey and dashed. `rotor plot` has a colour for each run instead.
is_printed(equations) = equations eq "published"
tint_of(equations) = is_printed(equations) ? "#0072b2" : "#b34700"
words_of(equations) = is_printed(equations) ? "equations as printed" : "corrected equations"
set colorsequence podo
blue = "#0072b2"; vermilion = "#d55e00"; green = "#009e73"; black = "#000000"; grey = "#707070"
set linetype 1 linecolor rgb blue linewidth 1.3
set linetype 2 linecolor rgb vermilion linewidth 1.3
set linetype 3 linecolor rgb green linewidth 1.3
set linetype 4 linecolor rgb black linewidth 1.3
set linetype 5 linecolor rgb "#cc79a7" linewidth 1.3
set linetype 6 linecolor rgb "#56b4e9" linewidth 1.3
set linetype 7 linecolor rgb "#e69f00" linewidth 1.3 dashtype (9, 6)
set linetype 8 linecolor rgb "#7a0177" linewidth 1.3 dashtype (5, 6)
published = 11; clearance = 12; reading = 13; fixed_steps = 14; lost = 16; law = 18
set style line 10 linecolor rgb tint_of("published") linewidth 1.3
set style line 20 linecolor rgb tint_of("consistent") linewidth 1.3
set style line 21 linecolor rgb "#d07f4a" linewidth 3    # wide and lighter beneath the other, so also in grey
set style line published linecolor rgb grey linewidth 1.2 dashtype (6, 7)
set style line clearance linecolor rgb black linewidth 1.2 dashtype (1, 5)
set style line fixed_steps linecolor rgb "#a0a0a0" linewidth 1.2
beneath = 3.4                                       # its width beneath a curve that may coincide
set style line lost pointtype 2 pointsize 1.2 linecolor rgb black linewidth 2
set style line law linecolor rgb "#7a0177" linewidth 1.2 dashtype (10, 6, 1, 6)
set style line reading linecolor rgb grey linewidth 0.8

# Outcomes by their code from 0 on: names and colours, which differ in lightness, so also in grey; the page has the same.
# And the palettes of maps.
array outcome_name[7] = ["no_contact", "undecided", "freed", "bouncing", "sliding", "rolling", "stalled"]
array outcome_tint[7] = ["#f7f7f5", "#efe0a0", "#a2c8e4", "#78aad2", "#2e5f8c", "#cc6c24", "#333333"]
with_spaces(name) = (at = strstrt(name, "_"), at == 0 ? name : name[:at - 1]." ".name[at + 1:])
outcome_words(code) = with_spaces(outcome_name[code + 1]).(code == 6 ? ", or no result" : "")
outcome_code(outcome) = 6 + sum [k = 1:6] (outcome eq outcome_name[k] ? k - 7 : 0)
outcome_palette = "set palette maxcolors 7 defined (0 outcome_tint[1], 1 outcome_tint[2], 2 outcome_tint[3], \
  3 outcome_tint[4], 4 outcome_tint[5], 5 outcome_tint[6], 6 outcome_tint[7]); set cbrange [-0.5:6.5]"
share_palette = "set palette defined (0 '#f4f4f4', 1 '#f3c9a0', 2 '#d55e00'); set cbrange [0:1]"
force_palette = "set palette defined \
  (0 '#fff7e0', 1 '#f5c56b', 2 '#e07b39', 3 '#a83a5a', 4 '#4b1d5e', 5 '#10082a')"

set border linewidth 0.8
set tics nomirror scale 0.7
set grid linetype 1 dashtype solid linecolor rgb "#d8d8d8" linewidth 0.6
set minussign
signed(form, x) = x < 0 ? "−".sprintf(form, -x) : "+".sprintf(form, x)
shortened(text, most) = strlen(text) > most ? text[:most/2 - 1]."…".text[strlen(text) - most/2 + 1:] : text
set key opaque samplen 2 spacing 1.15
set title offset 0,0.3
set style textbox opaque noborder margins 0.4,0.4

# "Fig. N" and its subject, with the parameters on a second line.
caption(number, what, parameters) = sprintf("{/:Bold Fig. %d}  %s\n{/*0.85 %s}", number, what, parameters)

# The column of one run, for scenes with several.
of_run(name, c) = strcol("run") eq name ? column(c) : NaN

# What settings.awk reads above the data; of the i-th run, and of the run with a name.
read_settings(data) = sprintf("load \"< awk -f '%s/../figures/paper/settings.awk' '%s'\"", reference_data, data)
if (exists("data")) { eval read_settings(data) }
of(what, i) = value(sprintf("%s%d", what, i))
its_place(run) = (sum [i = 1:known_runs] (of("run", i) eq run)*i)
number(run, name) = of(name, its_place(run))
# The largest force in rolling by the closed form, kN, if that predicts rolling, and its label:
friction_above(run, name) = number(run, "friction") > number(run, name)
law_kN(run) = !exists(sprintf("law_peak_force_N%d", its_place(run))) ? 0 : friction_above(run, "law_whirl_friction") && \
  friction_above(run, "law_forward_friction") ? 1e-3*number(run, "law_peak_force_N") : 0
mark_law(run) = law_kN(run) == 0 ? "" : (says_law = (equations eq word(sets, 1) ? "" : says_law.", ").sprintf("%.0f kN %s", \
  law_kN(run), short_of(equations)), sprintf("set arrow from graph 0,first %g to graph 1,first %g nohead linestyle law; ".\
  "set label 99 'closed form of rolling: ' . says_law at graph 0.985,first %g right offset 0,-0.7 textcolor rgb '#7a0177'", \
  -law_kN(run), -law_kN(run), -law_kN(run)))
by_method(run) = number(run, "method") eq "rk4" ? "published method" : "event method"
power_of_ten(x) = sprintf("%g×10^{%d}", x/10**floor(log10(x)), floor(log10(x)))

# y where x passes a value, interpolated between two rows: stats data using (follow(x, y, value)).
x_0 = NaN; y_0 = NaN; crossing = NaN
follow(x, y, at) = (x_0 < at && x >= at ? crossing = y_0 + (y - y_0)*(at - x_0)/(x - x_0) : 0, \
  x_0 = x, y_0 = y, 0)

# The position of O at a time and a little later, mm: eval place_at(run, time_s, a_little_s) sets y_1, x_1
# and y_2, x_2.
coordinate(run, c, t) = sprintf("stats data using (follow(of_run('%s', 'time_s'), of_run('%s', '%s')*1e3, %.17g)) nooutput; ", \
  run, run, c, t)
place_at(run, t, later) = coordinate(run, "y_a_m", t)."y_1 = crossing; ".coordinate(run, "x_a_m", t)."x_1 = crossing; ". \
  coordinate(run, "y_a_m", t + later)."y_2 = crossing; ".coordinate(run, "x_a_m", t + later)."x_2 = crossing"
set style arrow 5 head filled size screen 0.016,18,90 fixed linecolor rgb black linewidth 1

# The share, in percent, of the draws of a population (policy.md) for which a number of the claims holds: eval
# share_of("rolls_75", "b") sets rolls_75_b_max.
share_of(number, population) = sprintf("stats reference_data.'/ensembles.csv' using (strcol('equations') eq equations && \
  strcol('number') eq '%s' && strcol('population') eq '%s' ? 100*column('holds') : NaN) name '%s_%s' nooutput", \
  number, population, number, population)

# An instant on the axis of times: eval mark_instant("t_1", t_1); and that at which a run passes the critical speed:
# eval mark_critical("a").
mark_height = 0.12                                 # of its label
mark_instant(name, t) = sprintf("set arrow from %.17g,graph 0 to %.17g,graph 1 nohead linestyle reading; ".\
  "set label '%s' at %.17g,graph %g right offset -0.5,0 textcolor rgb grey front", t, t, name, t, mark_height)
critical_Hz(run) = sqrt(number(run, "support_stiffness")/number(run, "mass"))/(2*pi)
mark_critical(run) = sprintf("stats data using (follow(of_run('%s', 'speed_Hz'), of_run('%s', 'time_s'), %.17g)) nooutput; ", \
  run, run, critical_Hz(run))."eval mark_instant('critical speed', crossing)"

# Parts of captions.
greek(name) = name[1:3] eq "mu " ? "μ ".name[4:] : name    # of a run
friction(run) = sprintf("μ = %g", number(run, "friction"))
stiffness(run) = sprintf("k_t = %s N/m", power_of_ten(number(run, "contact_stiffness")))
loss(run) = number(run, "loses_mass") ? \
  sprintf("mass loss at t_1 = %g s", number(run, "mass_loss_time")) : "no mass loss"
clearance_of(run) = 1e3*(number(run, "stator_radius") - number(run, "rotor_radius"))    # mm
dotted(run) = sprintf("dotted: clearance r_a − r = %g mm", clearance_of(run))
motor(run, f) = f < number(run, "motor_off_hz") ? "motor still driving" : "motor off"

# The sets of equations that a figure shows, the first of its panels first, and in the order in which curves are drawn.
sets = (exists("data_published") ? "published " : "").(exists("data_consistent") ? "consistent" : "")
from_below = words(sets) == 2 ? "consistent published" : sets
data_of(set) = value("data_".set)
# plot @each_set using ... @layered: curves of which the upper ones leave the edges of the lower ones visible.
each_set = 'for [set in from_below] data_of(set)'
layer(set) = is_printed(set) ? 10 : words(sets) == 1 ? 20 : 21
layered = 'with lines linestyle layer(set) notitle'
# From here on data, equations, ours (a line style) and what is known of runs are those of one set: eval use(set).
use(set) = sprintf("undefine law_*; equations = '%s'; data = data_%s; ours = %d; ", set, set, is_printed(set) ? 10 : 20). \
  read_settings(data_of(set))
if (words(sets)) { eval use(word(sets, 1)) }

# The label of a curve in its equations' colour: eval label_curve(text, x, y, place).
short_of(equations) = is_printed(equations) ? "as printed" : "corrected"
label_curve(text, x, y, place) = sprintf("set label '%s' at %.17g,%.17g %s textcolor rgb '%s' boxed front", \
  text, x, y, place, tint_of(equations))

# A table of the paper's numbers and ours: eval table(x, y, letters) at a place of the graph, with heads of so many
# letters; eval row(1, head, paper's number); and, in each set of equations, eval ours_in(1, number).
cell(n, column, text, tint) = text eq "" ? "" : sprintf("set label '%s' at graph %g,graph %g right offset %g,%g textcolor rgb '%s' boxed front; ", \
  text, table_x, table_y, table_letters + 9*column, -1.25*n, tint)
column_of(set) = is_printed(set) || words(sets) == 1 ? 2 : 3
head_of(set) = strstrt(sets, set) ? cell(0, column_of(set), short_of(set), tint_of(set)) : ""
table(x, y, letters) = (table_x = x, table_y = y, table_letters = letters, \
  cell(0, 1, "paper", grey).head_of("published").head_of("consistent"))
row(n, head, paper) = sprintf("set label '%s' at graph %g,graph %g left offset 0,%g boxed front; ", \
  head, table_x, table_y, -1.25*n).cell(n, 1, paper, grey)
ours_in(n, number) = cell(n, column_of(equations), number, tint_of(equations))
