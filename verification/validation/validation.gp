# The accident by two codes; below, rebounds measured and by the engine's contact law. `folder` has the data.
eval "set terminal ".square
set multiplot layout 2,1 margins 0.11,0.97,0.08,0.93 spacing 0.14
set title "{/:Bold An independent code}: corrected equations, μ = 0.3"
set key top left
set xrange [9:34.4]; set yrange [0:500]
set xlabel "time after the mass loss, ms" offset 0,0.4
set ylabel "normal force, kN" offset 0.5,0
plot folder."/engine.csv" using (1e3*(column("time_s") - 29.1)):(-1e-3*column("normal_force_N")) with lines \
    linestyle 21 linewidth 5 title "engine", \
  folder."/force.csv" using (1e3*column("time_s")):(1e-3*column("normal_force_N")) with lines \
    linecolor rgb event_tint linewidth 1 title "LIGGGHTS"
set title "{/:Bold A measurement}: rebounds of a sphere, μ = 0.092" offset 0,-0.5
set key bottom right
set xrange [0:90]; set yrange [0.5:1]; set xtics 15
set xlabel "angle of incidence from the normal, degrees"
set ylabel "tangential restitution"
limit = atan(0.092*1.98*3.5)*180/pi    # of sliding throughout: tan = mu (1 + restitution) (1 + m r^2/I)
set arrow from limit, graph 0.2 to limit, graph 1 nohead linestyle clearance
set label "sticks" at limit - 1.5, 0.95 right
set label "slides throughout" at limit + 1.5, 0.95
plot folder."/rebounds.csv" using "angle_deg":"tangential_restitution" with lines linestyle 20 linewidth 2 \
    title "engine, no tangential compliance", \
  reference_data."/measured-rebounds.csv" using "angle_deg":"tangential_restitution" with points pointtype 6 \
    pointsize 1.3 linewidth 2 linecolor rgb event_tint title "measured: Kharaz, Gorham and Salman 2001"
