# Run time against error of the state in three scenes of build/bench/work-precision.csv, which is data.
eval "set terminal ".size(960, 470).sprintf(" font 'DejaVu Sans,%d' enhanced rounded", letters)
set multiplot layout 1,3 margins 0.09,0.98,0.3,0.83 spacing 0.025 title "{/:Bold Run time against error}"
set logscale xy
set format x "10^{%T}"
set xrange [3e-15:3] reverse; set xtics 1e-12,1e3
set yrange [1e-2:3e3]; set ytics 10
set xlabel "relative error of the state"
array tints[5] = [event_tint, "#e69f00", "#332288", "#332288", "#999933"]    # methods are no equations
methods = "'event Verner 8(7)' 'published RK4' 'GSL rk8pd' 'GSL rk8pd in our coordinates' 'Odeint Fehlberg 7(8)'"
of(scene, method, c) = strcol("problem") eq scene && strcol("method") eq method ? column(c) : NaN
do for [n = 1:3] {
  name = word("'rub mu = 0.3' 'no contact' 'run-up'", n)
  set title (n == 1 ? "rub, μ = 0.3" : name)
  set ylabel n == 1 ? "time, ms" : ""
  set format y n == 1 ? "10^{%T}" : ""
  if (n == 2) { set key at screen 0.53, screen 0.02 center bottom maxrows 3 Left reverse } else { unset key }
  plot for [k = 1:words(methods)] method = word(methods, k) data \
    using (of(name, method, "error_state")):(1e3*of(name, method, "time_s")) \
    with linespoints pointtype 4 + k linecolor rgb tints[k] linewidth 1.3 title method.(k == 1 ? ", ours" : "")
}
