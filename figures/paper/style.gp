# The look of all figures. The caller sets, with gnuplot's -e:
#   data      the figure's CSV file, columns addressed by name
#   output    the picture
#   format    svg, pdf or png
#   equations published (default) or consistent
#   points    files of points read off the printed figure, in its axes' units (default: none)
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
if (!exists("equations")) equations = "published"
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
ours = 10; published = 11; clearance = 12; reading = 13; fixed_steps = 14; lost = 16; law = 18
set style line ours linecolor rgb tint_of(equations) linewidth 1.3
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

# "Fig. N", its subject and its equations, with the parameters on a second line.
caption(number, what, parameters) = \
  sprintf("{/:Bold Fig. %d}  %s: {/:Bold %s}\n{/*0.85 %s}", number, what, words_of(equations), parameters)

# The paper's number beside ours, for annotations.
beside(what, ours, paper) = sprintf("{/:Bold %s}\nhere: %s\npaper: %s", what, ours, paper)

# The column of one run, for scenes with several.
of_run(name, c) = strcol("run") eq name ? column(c) : NaN

# Points read off the printed figure, drawn by `plot ... @digitised`; a script may restrict them to one run
# or quantity.
if (!exists("points")) points = ""
its_run = ""; its_quantity = ""
is_wanted(wanted, c) = wanted eq "" || strcol(c) eq wanted
read_off(c) = is_wanted(its_run, "run") && is_wanted(its_quantity, "quantity") ? column(c) : NaN
set style line 17 pointtype 4 pointsize 0.7 linecolor rgb black linewidth 1
set errorbars 0
digitised = points eq "" ? "" : ', for [file in points] file using \
  (read_off("x")):(read_off("y")):(read_off("x_error")):(read_off("y_error")) \
  with xyerrorbars linestyle 17 title file eq word(points, 1) ? "printed" : ""'

# What settings.awk reads above the data; of the i-th run, and of the run with a name.
if (exists("data")) { load sprintf("< awk -f '%s/../figures/paper/settings.awk' '%s'", reference_data, data) }
of(what, i) = value(sprintf("%s%d", what, i))
its_place(run) = (sum [i = 1:known_runs] (of("run", i) eq run)*i)
number(run, name) = of(name, its_place(run))
# The largest force in rolling by the closed form, kN, if that predicts rolling, and its label:
friction_above(run, name) = number(run, "friction") > number(run, name)
law_kN(run) = !exists(sprintf("law_peak_force_N%d", its_place(run))) ? 0 : friction_above(run, "law_whirl_friction") && \
  friction_above(run, "law_forward_friction") ? 1e-3*number(run, "law_peak_force_N") : 0
mark_law(run) = law_kN(run) > 0 ? sprintf("set arrow 9 from graph 0,first %g to graph 1,first %g nohead linestyle law; ".\
  "set label 9 'closed form of rolling: %.0f kN' at graph 0.985,first %g right offset 0,-0.7 textcolor rgb '#7a0177'", \
  -law_kN(run), -law_kN(run), law_kN(run), -law_kN(run)) : "unset arrow 9; unset label 9"
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
set style arrow 5 head filled size screen 0.022,18,90 fixed linecolor rgb black linewidth 1

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

# The label of a curve of a quantity over time, where it passes a value: eval label_where(run, "speed_Hz", 1, 100, "right").
# The sign -1 is that of a quantity that falls there.
label_where(run, c, sign, value, place) = sprintf("stats data using (follow(%d*of_run('%s', '%s'), of_run('%s', 'time_s'), ".\
  "%.17g)) nooutput; set label friction('%s') at crossing,%.17g %s front", sign, run, c, run, sign*value, run, value, place)

# Parts of captions.
greek(name) = name[1:3] eq "mu " ? "μ ".name[4:] : name    # of a run
friction(run) = sprintf("μ = %g", number(run, "friction"))
stiffness(run) = sprintf("k_t = %s N/m", power_of_ten(number(run, "contact_stiffness")))
loss(run) = number(run, "loses_mass") ? \
  sprintf("mass loss at t_1 = %g s", number(run, "mass_loss_time")) : "no mass loss"
clearance_of(run) = 1e3*(number(run, "stator_radius") - number(run, "rotor_radius"))    # mm
dotted(run) = sprintf("dotted: clearance r_a − r = %g mm", clearance_of(run))
motor(run, f) = f < number(run, "motor_off_hz") ? "motor still driving" : "motor off"
contact(run, rho_mm) = rho_mm < clearance_of(run) ? "no contact" : "contact"
