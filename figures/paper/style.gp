# The look of all pictures, and what the scripts of the paper's figures share. draw.sh sets output, format (svg, pdf or
# png), and the folders figures and reference_data; its caller sets with gnuplot's -e:
#   data      a CSV file, columns addressed by name; of a figure of the paper instead
#   data_published, data_corrected  its files in each set of equations, or in one of them. Beside each file.csv is
#             file.var: variables of each run, by its number: run1, its name, friction1, peak_normal_force_N1 and so on
# The picture is wide; for a square one a script has: eval "set terminal ".square

set datafile separator comma
set encoding utf8
letters = format eq "svg" ? 14 : format eq "png" ? 11 : 8
size(x, y) = format eq "svg" ? sprintf("svg background 'white' linewidth 1 size %g,%g", x, y) : \
  format eq "png" ? sprintf("pngcairo fontscale 2 pointscale 2 linewidth 2.4 dashlength 2.4 size %g,%g", 2*x, 2*y) : \
  sprintf("pdfcairo linewidth 0.7 size %.2fcm,%.2fcm", x/60.0, y/60.0)
wide = size(960, 560).sprintf(" font 'DejaVu Sans,%d' enhanced rounded", letters)
square = size(760, 800).sprintf(" font 'DejaVu Sans,%d' enhanced rounded", letters)
eval "set terminal ".wide
small = sprintf(",%g", 0.8*letters)                # a font for long keys
set output output

# A colour means one thing, in all pictures and on the page. What a run of ours shows has that of its equations, of which
# several runs have shades; the paper's values are grey and dashed, closed forms purple; events and the ring are black.
load figures."/paper/palette.gp"
part(tint, i) = int(real("0x".tint[2*i:2*i + 1]))
lighter(tint, w) = sum [i = 1:3] int(part(tint, i) + w*(255 - part(tint, i)) + 0.5)*256**(3 - i)
published = 11; clearance = 12; event = 13; lost = 16; law = 18
do for [i = 1:2] {                                 # of a run, and by fixed steps
  equations = word("published corrected", i)
  set style line 10*i linecolor rgb tint_of(equations) linewidth 1.3
  set style line 10*i + 4 linecolor rgb lighter(tint_of(equations), 0.5) linewidth 1.3
}
set style line 21 linecolor rgb lighter(tint_of("corrected"), 0.3) linewidth 3    # beneath the other, so also in grey
beneath = 3.4                                      # width of fixed steps beneath a curve that may coincide
set style line published linecolor rgb paper_tint linewidth 1.2 dashtype (6, 7)
set style line clearance linecolor rgb event_tint linewidth 1.2 dashtype (1, 5)
set style line event linecolor rgb event_tint linewidth 0.6
set style line lost pointtype 2 pointsize 1.2 linecolor rgb event_tint linewidth 2
set style arrow 5 head filled size screen 0.016,18,90 fixed linecolor rgb event_tint linewidth 1    # a sense
set style line law linecolor rgb law_tint linewidth 1.6
outcome_code(outcome) = 7 + sum [k = 1:7] (outcome eq outcome_name[k] ? k - 8 : 0)    # of none: no result
share_palette = sprintf("set palette defined (0 '#f4f4f4', 1 '%s'); set cbrange [0:1]", outcome_tint[6])
force_palette = "set palette defined \
  (0 '#fff7e0', 1 '#f5c56b', 2 '#e07b39', 3 '#a83a5a', 4 '#4b1d5e', 5 '#10082a')"

set border linewidth 0.8
set tics nomirror scale 0.7
set grid linetype 1 dashtype solid linecolor rgb "#d8d8d8" linewidth 0.6
set minussign
set key samplen 2 spacing 1.15
set title offset 0,0.3
set style textbox opaque noborder margins 0.4,0.4
signed(form, x) = x < 0 ? "−".sprintf(form, -x) : "+".sprintf(form, x)
shortened(text, most) = strlen(text) > most ? text[:most/2 - 1]."…".text[strlen(text) - most/2 + 1:] : text
greek(name) = name[1:3] eq "mu " ? "μ ".name[4:] : name    # of a run

# A variable of the i-th run, and of the run with a name; a column of that run, in data of several.
of(what, i) = value(sprintf("%s%d", what, i))
number(run, what) = of(what, sum [k = 1:known_runs] (of("run", k) eq run ? k : 0))
of_run(name, c) = strcol("run") eq name ? column(c) : NaN

# The sets of equations that a figure shows, in the order of its panels, and in that of curves. From `eval use(set)` on
# data, equations, ours (a line style) and the variables of runs are those of one set.
is_printed(set) = set eq "published"
sets = (exists("data_published") ? "published " : "").(exists("data_corrected") ? "corrected" : "")
from_below = words(sets) == 2 ? "corrected published" : sets
data_of(set) = value("data_".set)
use(set) = sprintf("equations = '%s'; data = data_of(equations); ours = %d; steps = ours + 4; load data[:strlen(data) - 4].'.var'", \
  set, is_printed(set) ? 10 : 20)
if (words(sets)) { eval use(word(sets, 1)) }
# plot @each_set using ... @layered: curves of which the upper ones leave the edges of the lower ones visible.
each_set = 'for [set in from_below] data_of(set)'
layer(set) = is_printed(set) ? 10 : words(sets) == 1 ? 20 : 21
layered = 'with lines linestyle layer(set) notitle'

# Parts of captions: "Fig. N" and its subject, with the parameters on a second line.
caption(number, what, parameters) = sprintf("{/:Bold Fig. %d}  %s\n{/*0.85 %s}", number, what, parameters)
power_of_ten(x) = sprintf("%g×10^{%d}", x/10**floor(log10(x)), floor(log10(x)))
friction(run) = sprintf("μ = %g", number(run, "friction"))
stiffness(run) = sprintf("k_t = %s N/m", power_of_ten(number(run, "contact_stiffness")))
loss(run) = number(run, "no_mass_loss") ? "no mass loss" : sprintf("mass loss at t_1 = %g s", number(run, "mass_loss_time"))
motor(run) = number(run, "motor_off_s") > 0 ? "motor off" : "motor still driving"
by_method(run) = number(run, "method") eq "rk4" ? "published method" : "event method"
clearance_of(run) = 1e3*(number(run, "stator_radius") - number(run, "rotor_radius"))    # mm
dotted(run) = sprintf("dotted: clearance r_a − r = %g mm", clearance_of(run))

# The share of the draws of a population (policy.md) for which a number of the claims holds, %, in ensembles.csv.
share(claim, population) = strcol("equations") eq equations && strcol("number") eq claim && \
  strcol("population") eq population ? 100*column("holds") : NaN
# y where x passes a value, interpolated between two rows: stats data using (follow(x, y, value)).
x_0 = NaN; y_0 = NaN; crossing = NaN
follow(x, y, at) = (x_0 < at && x >= at ? crossing = y_0 + (y - y_0)*(at - x_0)/(x - x_0) : 0, x_0 = x, y_0 = y, 0)

# What is drawn by eval: a line at a value, and with words of the paper; an instant with its name; the time at which a run
# passes the critical speed; at the peak of a run that rolls, its height by the closed form; and the name
# of a curve. Labels are drawn before the curves, so that their white edges hide none.
level(y, style) = sprintf("set arrow from graph 0,first %g to graph 1,first %g nohead linestyle %d; ", y, y, style)
says(text, x, y, place) = sprintf("set label '%s' at graph %g,first %g %s textcolor rgb paper_tint; ", text, x, y, place)
mark_height = 0.12                                 # of the name of an instant
mark_instant(name, t) = sprintf("set arrow from %.17g,graph 0 to %.17g,graph 1 nohead linestyle event; ".\
  "set label '%s' at %.17g,graph %g right offset -0.5,0", t, t, name, t, mark_height)
find_critical(run) = sprintf("stats data using (follow(of_run('%s', 'speed_Hz'), of_run('%s', 'time_s'), %.17g)) nooutput", \
  run, run, number(run, "critical_speed_Hz"))
says_law = ""; law_place = "graph 0.985,first %g right offset 0,-0.7"
mark_law(run) = (says_law = equations eq word(sets, 1) ? "" : says_law, kN = 1e-3*number(run, "law_peak_force_N"), \
  number(run, "outcome") ne "rolling" || !(kN > 0) ? "" : \
  (says_law = says_law.(says_law eq "" ? "estimate of the largest force: " : ", ").sprintf("%.0f kN %s", kN, short_of(equations)), \
  sprintf("set arrow from %.17g,%g rto graph 0.015,0 nohead linestyle law; ", number(run, "peak_time_s"), -kN). \
  sprintf("set label 99 says_law at ".law_place." textcolor rgb law_tint", -kN)))
label_curve(text, x, y, place) = sprintf("set label '%s' at %.17g,%.17g %s textcolor rgb '%s' boxed", \
  text, x, y, place, tint_of(equations))

# A table of the paper's numbers and ours: eval table(x, y, letters) at a place of the graph, with heads of so many
# letters; eval row(1, head, paper's number); and, in each set of equations, eval ours_in(1, number).
cell(n, place, offset, text, tint) = text eq "" ? "" : sprintf("set label '%s' at graph %g,graph %g %s offset %g,%g textcolor rgb '%s' \
  boxed; ", text, table_x, table_y, place, offset, -1.25*n, tint)
column_at(set) = table_letters + (set eq "paper" ? 9 : is_printed(set) || words(sets) == 1 ? 18 : 27)
head_of(set) = cell(0, "right", column_at(set), short_of(set), tint_of(set))
table(x, y, letters) = (table_x = x, table_y = y, table_letters = letters, cell(0, "right", column_at("paper"), "paper", paper_tint). \
  head_of(word(sets, 1)).(words(sets) == 2 ? head_of("corrected") : ""))
row(n, head, paper) = cell(n, "left", 0, head, event_tint).cell(n, "right", column_at("paper"), paper, paper_tint)
ours_in(n, number) = cell(n, "right", column_at(equations), number, tint_of(equations))
