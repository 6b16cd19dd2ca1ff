# Force against time in the paper's ring and in others that give way as far, in the first impact (left) or in rolling (right).
# `folder` has a trace of each row of contact-laws.csv.
eval "set terminal ".wide
set multiplot layout 1,2 margins 0.075,0.985,0.12,0.9 spacing 0.08 \
  title "{/:Bold Other contact laws}, indented as far as the paper's linear one in the first impact (left) or in rolling (right); μ = 0.3, as printed"
set ylabel "normal force, kN" offset 1,0
same = "impact rolling"; names = "1 1.25 1.5"
array dashes[3] = ["solid", "(9,4)", "(3,3)"]
do for [n = 1:3] {
  set style line (30 + n) linecolor rgb lighter(tint_of("published"), 0.25*(n - 1)) linewidth 1.6
  eval sprintf("set style line %d dashtype %s", 30 + n, dashes[n])
}
loss = 29.1
do for [i = 1:2] {
  if (i == 1) { set key top left font small samplen 4; set xrange [4.2:4.9] } else { unset key; set xrange [4:52] }
  set yrange [0:*]
  set xlabel (i == 1 ? "time after the mass loss, ms: first impact" : "time after the mass loss, ms") offset 0,0.4
  name(n) = folder."/".(n == 1 ? "" : word(same, i))."-".word(names, n).".csv"
  plot for [n = 1:3] name(n) using (1e3*(column("time_s") - loss)):(-1e-3*column("normal_force_N")) with lines \
    linestyle (30 + n) title sprintf("F ∝ Δ^{%s}", word(names, n))
}
unset multiplot
