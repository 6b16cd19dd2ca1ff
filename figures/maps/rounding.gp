# The share of rotors that roll, over the rounding of what rounding.toml samples, and half of its 95 % interval
# (Clopper and Pearson). The caller sets what style.gp needs; data are shares by map-statistics, and
# note what tolerance.sh says of the map.
eval "set terminal ".square
stats data using (1) nooutput name "all"
panel = int(all_records)/2
stats data every ::0::0 using "draws" nooutput name "draws"
set multiplot title sprintf("{/:Bold Backward rolling over the rounding of rotor, supports, ring and lost mass}\n{/*0.8 %d draws at each point; ", draws_max). \
  system(sprintf("cat '%s'", note))."}"
set tics front out; set xtics 40
unset grid; unset key; unset colorbox
set xrange [*:*] noextend; set yrange [*:*] noextend
top = 0.88; bottom = 0.09; height = (top - bottom)/2
do for [p = 0:3] {
  at_left = p % 2 == 0; at_bottom = p/2 == 1
  set lmargin at screen at_left ? 0.1 : 0.49
  set rmargin at screen at_left ? 0.455 : 0.845
  set tmargin at screen top - height*(p/2) - 0.03
  set bmargin at screen top - height*(p/2 + 1) + 0.02
  first = (p % 2)*panel
  stats data every ::first::first using (titled = words_of(strcol("equations")), column("draws")) nooutput
  set title titled offset 0,-0.6
  set format x (at_bottom ? "%g" : ""); set format y (at_left ? "%g" : "")
  set xlabel (at_bottom ? "speed at the mass loss, Hz" : "") offset 0,0.4
  set ylabel (at_left ? "coefficient of friction μ" : "") offset 0.5,0
  if (at_bottom) {
    set palette defined (0 "#ffffff", 1 event_tint)
    set cbrange [0:0.11]; set cblabel "half of the 95 % interval of the share" offset 1,0
  } else {
    eval share_palette; set cblabel "share that rolls" offset 1,0
  }
  if (at_left) { unset colorbox } else {
    set colorbox user origin screen 0.86, graph 0 size screen 0.025, graph 1
  }
  eval sprintf("plot data every ::%d::%d using (column('start_speed_Hz')):(column('friction')):(column('%s')) with image %s", \
    first, first + panel - 1, at_bottom ? "half_interval" : "rolling_share", format eq "png" ? "" : "pixels")
}
unset multiplot
