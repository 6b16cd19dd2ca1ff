# Run time against error of the state for a scene of build/bench/work-precision.csv, stated by its number.
# The dashed line is the error of the reference. The caller sets, besides what style.gp needs, scene.
set logscale xy
set format x "10^{%T}"
set format y "10^{%T}"
set xlabel "largest relative error of position, velocity and speed"
set ylabel "time, ms"
set xrange [1e-17:1] reverse
set key outside right top Left reverse
scenes = "'run-up' 'rub mu = 0.3' 'rub mu = 0.2' 'rub mu = 0.08' 'no contact' 'single impact' 'rolling'"
methods = "'event Verner 8(7)' 'published RK4' 'GSL rk8pd' 'GSL rk8pd in our coordinates' 'Odeint Fehlberg 7(8)'"
of(scene, method, c) = strcol("problem") eq scene && strcol("method") eq method ? column(c) : NaN
name = word(scenes, scene)
set title "{/:Bold Run time against error:} ".name
stats data using (of(name, "reference", "error_state")) name "reference" nooutput
set arrow from reference_min, graph 0 to reference_min, graph 1 nohead dashtype 2 linecolor "gray"
plot for [k = 1:words(methods)] method = word(methods, k) data \
  using (of(name, method, "error_state")):(1e3*of(name, method, "time_s")) \
  with linespoints pointtype 4 + k linetype k linewidth 1.3 title method
