# Runs against laws for part of the random rotors of laws.toml: speed at the onset of rolling, largest force.
sparse = 17                                        # one of so many is drawn
eval "set terminal ".wide
set multiplot layout 1,2 margins 0.085,0.985,0.16,0.86 spacing 0.1 \
  title sprintf("{/:Bold Random rotors that roll}, one in %d of them: runs against closed forms\n".\
  "{/*0.85 share: of the unbalance, κ e_{x1}/(μ r); agree: of all, within 10 %%, between the dashed lines}", sparse)
set key bottom right noopaque font small samplen 0.5
array group[2] = ["share above 0.1", "up to 0.1"]
array tint[2] = ["#e69f00", event_tint]
in_group(g) = strcol("outcome") eq "rolling" && (column("law_unbalance_share") < 0.1) == g - 1
array of[2] = ["speed at which rolling begins, Hz", "largest normal force, kN"]
array run[2] = ["rolling_onset_speed_Hz", "peak_force_to_rolling_N"]
array law[2] = ["law_rolling_speed_Hz", "law_peak_force_N"]
array unit[2] = [1, 1e3]
array most[2] = [300, 2e4]
do for [i = 1:2] {
  # Of all rotors, in percent.
  array within[2]
  unset logscale; set xrange [*:*]; set yrange [*:*]
  do for [g = 1:2] {
    stats data using (in_group(g) ? abs(column(run[i])/column(law[i]) - 1) <= 0.1 : NaN) nooutput
    within[g] = 100*STATS_mean
  }
  set logscale xy; set xrange [0.5:most[i]]; set yrange [0.5:most[i]]
  set xlabel (of[i].": law") offset 0,0.4
  set ylabel "run" offset 1,0
  plot for [g = 1:2] data every sparse using (column(law[i])/unit[i]):(in_group(g) ? column(run[i])/unit[i] : NaN) \
      with points pointtype 7 pointsize 0.22 linecolor rgb tint[g] title sprintf("%s: %.0f %% agree", group[g], within[g]), \
    x with lines linecolor rgb law_tint notitle, \
    for [p = 90:110:20] 0.01*p*x with lines linecolor rgb law_tint dashtype (6,7) notitle
}
unset multiplot
