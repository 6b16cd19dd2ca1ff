# The accident by two codes; below, how far they differ in all cases, and rebounds measured and by the engine's contact
# law. `folder` has the data.
tall = 1270.
eval "set terminal ".size(760, tall).sprintf(" font 'DejaVu Sans,%d' enhanced rounded", letters)
panel(left, top, bottom) = sprintf("set lmargin at screen %g; set rmargin at screen 0.97; \
  set tmargin at screen %g; set bmargin at screen %g", left, 1 - top/tall, 1 - bottom/tall)
set multiplot
eval panel(0.11, 50, 330)
set title "{/:Bold An independent code}: corrected equations, μ = 0.3"
set key top left
set xrange [9:34.4]; set yrange [0:500]
set xlabel "time after the mass loss, ms" offset 0,0.4
set ylabel "normal force, kN" offset 0.5,0
plot folder."/engine.csv" using (1e3*(column("time_s") - 29.1)):(-1e-3*column("normal_force_N")) with lines \
    linestyle 21 linewidth 5 title "engine", \
  folder."/force.csv" using (1e3*column("time_s")):(1e-3*column("normal_force_N")) with lines \
    linecolor rgb event_tint linewidth 1 title "LIGGGHTS"

# Each case has a row, and a mark for each quantity but the count of touch-downs, which has no share.
independent = reference_data."/independent.csv"
row_of(name) = name eq "case" ? NaN : \
  (cases = column(0) <= 1 && cases > 1 ? 0 : cases, cases = name eq before ? cases : cases + 1, before = name, cases)
mark_of(quantity) = quantity[1:10] eq "touch_down" ? 6 : quantity[1:4] eq "peak" ? 4 : 8
share(quantity) = quantity eq "touch_downs" ? NaN : abs(column("difference"))/column("allowed")
cases = 0; before = ""
stats independent using (row_of(strcol("case"))) nooutput
eval panel(0.44, 440, 830)
set title "{/:Bold All cases}, the last six with a mistake: differences, as shares of what is allowed" offset -11,-0.3
set logscale x; set xrange [1e-6:1e4]; set format x "10^{%T}"
set yrange [STATS_max + 0.6:0.4]; unset ytics
set xlabel "difference / allowed"; unset ylabel
set key bottom left font small
set arrow from 1, graph 0 to 1, graph 1 nohead linestyle clearance
plot independent using (share(strcol("quantity"))):(row_of(strcol("case"))):(mark_of(strcol("quantity"))) \
    with points pointtype variable pointsize 0.9 linewidth 1.4 linecolor rgb event_tint notitle, \
  "" using (1e-6):(strcol("case") eq before ? NaN : row_of(strcol("case"))):(strcol("case")) with labels right offset -1,0 noenhanced font small notitle, \
  "" using (strcol("liggghts") eq "" && mark_of(strcol("quantity")) == 4 ? 2 : NaN):(row_of(strcol("case"))):("does not come to that") with labels left font small notitle, \
  keyentry with points pointtype 6 linecolor rgb event_tint title "times of touch-downs", \
  keyentry with points pointtype 4 linecolor rgb event_tint title "largest force", \
  keyentry with points pointtype 8 linecolor rgb event_tint title "speeds"
unset arrow; unset logscale; set format x "%g"; set ytics autofreq

eval panel(0.11, 930, 1210)
set title "{/:Bold A measurement}: rebounds of a sphere, μ = 0.092" offset 0,-0.5
set key bottom right
set xrange [0:90]; set yrange [0.5:1]; set xtics 15
set xlabel "angle of incidence from the normal, degrees"
set ylabel "tangential restitution"
limit = atan(0.092*1.98*3.5)*180/pi    # of sliding throughout: tan = mu (1 + restitution) (1 + m r^2/I)
set arrow from limit, graph 0.2 to limit, graph 1 nohead linestyle clearance
set label "sticks" at limit - 1.5, 0.95 right
set label "slides throughout" at limit + 1.5, 0.95
plot folder."/rebounds.csv" using "angle_deg":"tangential_restitution" with lines linestyle 20 linewidth 2 \
    title "engine, no tangential compliance", \
  reference_data."/measured-rebounds.csv" using "angle_deg":"tangential_restitution" with points pointtype 6 \
    pointsize 1.3 linewidth 2 linecolor rgb event_tint title "measured: Kharaz, Gorham and Salman 2001"
