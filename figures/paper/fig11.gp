# F_n for three contact stiffnesses.
set title caption(11, "Influence of the contact stiffness on the radial force F_n", \
  friction("k_t").", ".stiffness("k_t").", ".loss("k_t"))
runs = "'k_t' '2 k_t' '0.5 k_t'"
load figures."/paper/forces.gp"
do for [i = 1:3] {
  @begin_panel
  if (i == 1) { eval level(-455, published).says("paper: 455 kN", 0.985, -455, "right offset 0,-0.7") }
  eval table(0.01, 0.55, 7)
  set label "{/:Bold ".name."}" at graph 0.01,0.55 left boxed
  eval row(1, "largest |F_n|", i == 1 ? "455 kN" : "")
  if (i > 1) { eval row(2, "change", "minor") }
  do for [set in sets] {
    eval use(set)
    eval ours_in(1, sprintf("%.1f kN", kN(name)))
    if (i == 1) { eval label_curve(short_of(set), is_printed(set) ? 29.154 : 29.134, is_printed(set) ? -270 : -230, "left") }
    if (i > 1) { eval ours_in(2, signed("%.0f", 100*(kN(name)/kN("k_t") - 1))." %") }
  }
  plot [29.1:29.16] [-560:0] @force_curves
}
