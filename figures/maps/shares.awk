# The share of draws that roll at each point of a sweep's axes. The rows of a point are adjacent.
BEGIN { FS = OFS = "," }
/^#/ { print; next }
!outcome {
  for (i = 1; i <= NF; ++i) if ($i == "outcome") outcome = i
  print "equations", $2, $3, "draws", "rolling_share", "standard_error"
  next
}
{ point = $1 OFS $2 OFS $3 }
point != last { print_share(); last = point; draws = rolling = 0 }
{ ++draws; rolling += $outcome == "rolling" }
END { print_share() }
function print_share(share) {
  if (!draws) return
  share = rolling / draws
  print last, draws, share, sqrt(share * (1 - share) / draws)
}
