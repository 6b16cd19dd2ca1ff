# Run time against error of the state, one picture for each scene of build/bench/work-precision.csv.
# The dashed line is the error of the reference. The caller sets data, folder and format, and loads
# figures/paper/style.gp first.
set logscale xy
set format x "10^{%T}"
set format y "10^{%T}"
set xlabel "largest relative error of position, velocity and speed"
set ylabel "time, ms"
set xrange [1e-17:1] reverse
set key outside right top Left reverse
scenes = "'run-up' 'rub mu = 0.3' 'rub mu = 0.2' 'rub mu = 0.08' 'no contact' 'single impact' 'rolling'"
methods = "'event Verner 8(7)' 'published RK4' 'GSL rk8pd' 'GSL rk8pd in our coordinates'"
of(scene, method, c) = strcol("problem") eq scene && strcol("method") eq method ? column(c) : NaN
do for [i = 1:words(scenes)] {
  scene = word(scenes, i)
  set output folder."/work-precision-".i.".".format
  set title "{/:Bold Run time against error:} ".scene
  unset arrow
  stats data using (of(scene, "reference", "error_state")) name "reference" nooutput
  set arrow from reference_min, graph 0 to reference_min, graph 1 nohead dashtype 2 linecolor "gray"
  plot for [k = 1:words(methods)] method = word(methods, k) data \
    using (of(scene, method, "error_state")):(1e3*of(scene, method, "time_s")) \
    with linespoints pointtype 4 + k linetype k linewidth 1.3 title method
}
