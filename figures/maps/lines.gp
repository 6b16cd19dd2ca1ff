# Lines on which a closed form equals the quantity it is compared with: contours of no excess, $line_PANEL_FORM. The
# caller sets theory, the output of map-theory, panels, forms, and the scales along_x and along_y. A
# plane without any contour is drawn with each, because gnuplot refuses to draw nothing.
$plane << END
0,0
1,0

0,1
1,1
END
set datafile separator comma
set contour base
unset surface
set cntrparam levels discrete 0
do for [p = 0:panels - 1] {
  do for [i = 1:forms] {
    eval sprintf("set table $line_%d_%d", p, i)
    splot $plane using 1:2:(1 + $1), theory index p using (along_x($1)):(along_y($2)):(column(i + 2))
    unset table
  }
}
unset contour
set surface
