# Runs against laws for part of the random rotors of laws.toml: speed at the onset of rolling, largest force.
limit = 0.1
sparse = 17                                        # one of so many is drawn
eval "set terminal ".wide
set multiplot layout 1,2 margins 0.085,0.985,0.16,0.86 spacing 0.1 \
  title sprintf("{/:Bold Random rotors that roll}, one in %d of them: runs against closed forms, within 10 %% between the dashed lines", sparse)
set logscale xy
set key bottom right noopaque font small samplen 0.5
share = "law_unbalance_share"
y(name, unit, low, high) = strcol("outcome") eq "rolling" && column(share) >= low && column(share) < high ? column(name)/unit : NaN
panels = "rolling_onset_speed_Hz law_rolling_speed_Hz peak_force_to_rolling_N law_peak_force_N"
array of[2] = ["speed at which rolling begins, Hz", "largest normal force, kN"]
array units[2] = [1, 1e3]
array least[2] = [0.5, 0.5]
array most[2] = [300, 2e4]
do for [i = 1:2] {
  run = word(panels, 2*i - 1); law = word(panels, 2*i)
  set xrange [least[i]:most[i]]; set yrange [least[i]:most[i]]
  set xlabel (of[i].": law") offset 0,0.4
  set ylabel "run" offset 1,0
  plot data every sparse using (column(law)/units[i]):(y(run, units[i], limit, 1e9)) with points pointtype 7 pointsize 0.22 \
      linecolor rgb "#e69f00" title sprintf("share of the unbalance κ e_{x1}/(μ r) above %g", limit), \
    data every sparse using (column(law)/units[i]):(y(run, units[i], 0, limit)) with points pointtype 7 pointsize 0.22 \
      linecolor rgb event_tint title sprintf("up to %g", limit), \
    x with lines linecolor rgb law_tint notitle, \
    for [p = 90:110:20] 0.01*p*x with lines linecolor rgb law_tint dashtype (6,7) notitle
}
unset multiplot
