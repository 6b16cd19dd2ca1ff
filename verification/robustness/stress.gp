# Pictures of the stress tests: stability of the published method's steps, error against precision,
# growth of a disturbance from contact to contact, residuals of the random rotors. The caller sets folder and format, and loads
# figures/paper/style.gp first.
file(name) = folder."/".name.".".format

set output file("stability")
set title "{/:Bold Largest stable step of the published method} (lines: linear theory of a straight ring)"
set logscale xy
set format x "10^{%T}"
set format y "10^{%T}"
set xlabel "contact stiffness k_t, N/m"
set ylabel "step, s"
set key top right
dampings = "0 10000 1000000 10000000"
of(d, c) = column("contact_damping_Ns_per_m") == d ? column(c) : NaN
k_t = "contact_stiffness_N_per_m"
data = folder."/stability.csv"
set arrow from 8e8, graph 0 to 8e8, graph 1 nohead linestyle published
set label "the paper's k_t" at 8e8, graph 0.96 offset 0.5,0
set arrow from graph 0, first 5e-6 to graph 1, first 5e-6 nohead linestyle published
set label "and step" at graph 0.02, first 5e-6 offset 0,0.6
plot for [i = 1:words(dampings)] data using (column(k_t)):(of(word(dampings, i) + 0, "linear_theory_s")) \
       with lines linetype i notitle, \
     for [i = 1:words(dampings)] data using (column(k_t)):(of(word(dampings, i) + 0, "limit_s")) \
       with points pointtype 4 + i linetype i title sprintf("d_t = %.0e N s/m", word(dampings, i) + 0)
unset arrow
unset label

set output file("precision")
set title "{/:Bold Error against tolerance, by precision:} position at 29.35 s"
set xlabel "tolerance"
set ylabel "error relative to the clearance"
set xrange [1e-18:1e-2]
set yrange [1e-16:10]
set key bottom right
in(f, p, c) = column("friction") == f && strcol("precision") eq p ? column(c) : NaN
precisions = "single double extended"
frictions = "0.3 0.08"
plot for [i = 1:2] for [k = 1:3] folder."/precision.csv" \
  using (column("tolerance")):(in(word(frictions, i) + 0, word(precisions, k), "error")) \
  with linespoints linetype k pointtype (i == 1 ? 7 : 6) \
  title sprintf("mu = %s, %s", word(frictions, i), word(precisions, k))

set output file("growth")
set title "{/:Bold A disturbance of the position} at the mass loss, from contact to contact"
unset logscale x
set format x "%g"
set xrange [0:*]
set yrange [*:*]
set xlabel "contact"
set ylabel "times its size"
set key at graph 0.98, graph 0.3
with(f, c) = column("friction") == f ? column(c) : NaN
all = "0.3 0.2 0.08"
plot for [i = 1:3] folder."/growth.csv" using (column("contact")):(with(word(all, i) + 0, "factor")) \
  with linespoints pointtype 7 title "mu = ".word(all, i)

set boxwidth 0.36
set output file("residuals")
set title "{/:Bold Defects of the random rotors}, at a tolerance of 1e-9"
set xrange [-17.8:-3.2]
set yrange [0.5:1e7]
set xlabel "residual"
set format x "10^{%g}"
set format y "10^{%T}"
set ylabel "rotors with less than that, and not less than a tenth of it"
set key default
set key top right opaque samplen 2 spacing 1.15
set style fill solid 0.8
set arrow from -8,graph 0 to -8,graph 1 nohead linetype 2 dashtype (6,4)
set arrow from -6,graph 0 to -6,graph 1 nohead linetype 1 dashtype (6,4)
plot folder."/residuals.csv" using (column("below_ten_to_the") - 0.2):(column("residuals")) with boxes linetype 1 \
       title "balances of energy and angular momentum (dashed: beyond, run again)", \
     "" using (column("below_ten_to_the") + 0.2):(column("penetrations")) with boxes linetype 2 \
       title "penetration of the ring while free, relative to the clearance"
