# F_n for high, intermediate and low friction, one above the other.
set title caption(3, "Radial component F_n of the impact force", \
  sprintf("%s, f_{max} = %g Hz, %s; wide grey: %s, steps of %g μs", loss("mu = 0.3"), \
    number("mu = 0.3", "motor_off_hz"), stiffness("mu = 0.3"), by_method("mu = 0.3 by rk4"), \
    1e6*number("mu = 0.3 by rk4", "step_rub")))
set multiplot layout 3,1 margins 0.115,0.97,0.11,0.87 spacing 0,0.035
set xrange [29.1:29.35]
set yrange [-600:0]
set ytics -400,200,0
set ylabel "F_n, kN"
set format x ""
force(name) = of_run(name, "normal_force_N")/1e3
runs = "'mu = 0.3' 'mu = 0.2' 'mu = 0.08'"
do for [i = 1:3] {
  name = word(runs, i)
  stats data using (force(name)) name "F" nooutput
  set label 1 "{/:Bold ".friction(name)."}" at graph 0.985,0.64 right boxed front
  set label 2 sprintf("largest |F_n|: %.1f kN", -F_min) at graph 0.985,0.48 right boxed front
  if (i == 1) { set label 3 "paper: 400–450 kN in rolling, largest 455 kN" at graph 0.985,first -455 right offset 0,0.6 \
                  textcolor rgb grey boxed front
                set arrow 1 from graph 0,first -455 to graph 1,first -455 nohead linestyle published }
  else { unset label 3; unset arrow 1 }
  eval mark_law(name)
  if (i == 2) { unset title }
  if (i == 3) { set xlabel "t, s" offset 0,0.4; set format x "%.2f" }
  fixed = name." by rk4"
  its_run = name
  plot data using (of_run(fixed, "time_s")):(force(fixed)) \
  with lines linestyle fixed_steps linewidth beneath notitle, \
    data using (of_run(name, "time_s")):(force(name)) with lines linestyle ours notitle @digitised
}
