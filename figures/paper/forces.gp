# F_n of three runs, one above the other: in panel i, of the run `name`, a script has @begin_panel, what it marks, and plots
# @force_curves.
set multiplot layout 3,1 margins 0.115,0.97,0.11,0.87 spacing 0,0.035
set ytics -600,200,0
set ylabel "F_n, kN"
set format x ""
force(name) = of_run(name, "normal_force_N")/1e3
kN(run) = 1e-3*number(run, "peak_normal_force_N")
begin_panel = 'name = word(runs, i); unset label; unset arrow; if (i == 2) { unset title }; \
  if (i == 3) { set xlabel "t, s" offset 0,0.4; set format x "%.2f" }'
force_curves = '@each_set using (of_run(name, "time_s")):(force(name)) @layered'
