# What the lines above a data file say, as settings for gnuplot: known_runs; of each run, by its number, run1 (its name), method1,
# loses_mass1 and its numbers, mass1, law_reach_m1 and so on; points_of_sweep; and the places of columns, column_time_s.
!/^#/ {
  for (n = split($0, headings, ","); n; --n) print "column_" headings[n] " = " n
  exit
}
/^# [0-9]+ points, / { print "points_of_sweep = " $2 }
match($0, /: (equations|by closed forms,) /) {
  name = substr($0, 3, RSTART - 3)
  if (!(name in number)) number[name] = ++known
  n = number[name]
  for (k = split(substr($0, RSTART + 2), facts, ", "); k; --k) {
    split(facts[k], word, " ")
    if (word[2] == "=") print word[1] n " = 1.0*" word[3]
    if (word[1] == "method") print "method" n " = '" word[2] "'; loses_mass" n " = " !/, no mass loss$/
  }
  gsub(/'/, "''", name)
  print "run" n " = '" name "'; known_runs = " known
}
