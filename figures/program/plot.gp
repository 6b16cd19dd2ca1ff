# Force, speed, displacement and orbit of any scene. `rotor plot` sets, beside what style.gp wants:
#   heading, runs, the names run1, run2, ... and clearance_mm1, clearance_mm2, ...
# In the data runs have their numbers for names.

gap(i) = value(sprintf("clearance_mm%d", i))
name(i) = value(sprintf("run%d", i))
of(i, c) = of_run(sprintf("%d", i), c)
set multiplot layout 2,2 title heading noenhanced margins 0.1,0.97,0.1,0.9 spacing 0.12,0.13
set key noenhanced
set xlabel "t, s" offset 0,0.4
set ylabel "F_n, kN" offset -0.5,0
plot for [i = 1:runs] data using (of(i, "time_s")):(of(i, "normal_force_N")/1e3) \
  with lines linetype i title (runs > 1 ? name(i) : "")
set ylabel "f, Hz"
plot for [i = 1:runs] data using (of(i, "time_s")):(of(i, "speed_Hz")) with lines linetype i notitle
set ylabel "rho, mm"
plot for [i = 1:runs] gap(i) with lines linestyle clearance title (i == 1 ? "clearance" : ""), \
  for [i = 1:runs] data using (of(i, "time_s")):(of(i, "rho_m")*1e3) with lines linetype i notitle
set ylabel "x_a, mm (down)"
set xlabel "y_a, mm"
set size ratio -1
set yrange [] reverse
set parametric
set trange [0:2*pi]
plot for [i = 1:runs] gap(i)*cos(t), gap(i)*sin(t) with lines linestyle clearance notitle, \
  for [i = 1:runs] data using (of(i, "y_a_m")*1e3):(of(i, "x_a_m")*1e3) with lines linetype i notitle
unset multiplot
