#!/usr/bin/env bash
# Runs the random rotors of differential.toml twice, and fails if their results differ:
#   differential.sh COUNT FOLDER PROGRAM STOP PROGRAM STOP [TOLERANCE]
# PROGRAM is a rotor, old or new; STOP is where its runs stop: outcome, or end. What the first one leaves empty
# is not compared, nor is what a run says about itself. TOLERANCE is relative, by default 0.
set -euo pipefail
count=$1 folder=$2 tolerance=${7:-0}
mkdir -p "$folder"
sweep() { # PROGRAM STOP NAME
  { echo "stop_on = \"$2\""; sed "s/^count = .*/count = $(((count + 5) / 6))/" "$(dirname "$0")/differential.toml"; } >"$folder/$3.toml"
  rm -f "$folder/$3.csv.journal"
  "$1" sweep "$folder/$3.toml" --out "$folder/$3.csv" >"$folder/$3.log" 2>&1 || { cat "$folder/$3.log" >&2; exit 1; }
}
sweep "$3" "$4" first
sweep "$5" "$6" second
LC_ALL=C awk -F, -v tolerance="$tolerance" '
  BEGIN {
    split("final_time_s stop_on stop_reached right_hand_sides contact_evaluations steps located_events remarks", of_run, " ")
    for (n in of_run) skipped[of_run[n]] = 1
  }
  /^#/ { next }
  FNR != NR && !rows { for (n = 1; n <= NF; ++n) name[n] = $n; rows = 1; next }
  FNR == NR && !first_rows { for (n = 1; n <= NF; ++n) place[$n] = n; first_rows = 1; next }
  FNR == NR { first[first_rows++] = $0; next }
  {
    split(first[rows++], of_first, ",")
    compared += of_first[place["outcome"]] != ""
    for (n = 1; n in name; ++n) {
      a = of_first[place[name[n]]]; b = $n
      if (!(name[n] in place) || name[n] in skipped || a == "" || a == b) { if (name[n] == "remarks") break; continue }
      size = b < 0 ? -b : b; off = a - b; off = (off < 0 ? -off : off)/(size > 0 ? size : 1)
      if (b + 0 == b && off <= tolerance) continue
      ++different[name[n]]
      if (!(name[n] in worst) || off > worst[name[n]]) { worst[name[n]] = off; where[name[n]] = rows - 1 " (" a " against " b ")" }
    }
  }
  END {
    printf "%d random rotors, %d of them with an outcome\n", rows - 1, compared
    for (key in different) {
      printf "  %s differs in %d rows, by %.1e at most in row %s\n", key, different[key], worst[key], where[key]
      failed = 1
    }
    exit failed || rows != first_rows || compared == 0
  }' "$folder/first.csv" "$folder/second.csv"
