# What the lines above a data file say, as settings for gnuplot: known_runs; of each run, by its number, run1 (its name), method1,
# loses_mass1 and its numbers, mass1, law_reach_m1 and so on; points_of_sweep; and the places of columns, column_time_s. Only
# names and numbers are passed on, because gnuplot executes what it reads here.
function is_name(text) { return text ~ /^[A-Za-z_][A-Za-z_0-9]*$/ }
function is_number(text) { return text ~ /^-?[0-9]+(\.[0-9]+)?(e[-+]?[0-9]+)?$/ }
!/^#/ {
  for (n = split($0, headings, ","); n; --n) if (is_name(headings[n])) print "column_" headings[n] " = " n
  exit
}
/^# [0-9]+ points, / { print "points_of_sweep = " $2 }
match($0, /: (equations|by closed forms,) /) {
  name = substr($0, 3, RSTART - 3)
  if (!(name in number)) number[name] = ++known
  n = number[name]
  for (k = split(substr($0, RSTART + 2), facts, ", "); k; --k) {
    split(facts[k], word, " ")
    if (word[2] == "=" && is_name(word[1]) && is_number(word[3])) print word[1] n " = 1.0*" word[3]
    if (word[1] == "method" && is_name(word[2])) print "method" n " = '" word[2] "'; loses_mass" n " = " !/, no mass loss$/
  }
  gsub(/'/, "''", name)
  print "run" n " = '" name "'; known_runs = " known
}
