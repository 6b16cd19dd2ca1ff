#!/usr/bin/env bash
# How many results of random rotors a change of the engine alters, beside those that its tolerance leaves open:
#   differential.sh OLD NEW COUNT [TOLERANCE]
# runs COUNT rotors by the programs OLD and NEW at a tolerance of 1e-11, and by OLD at 1e-12. A row is a rotor whose
# results differ by more than TOLERANCE (default 1e-6) of their value, or in a count or a name. Fails if more rows differ
# between NEW and OLD than between OLD's tolerances. Needs build/random-rotors.
set -euo pipefail
old=$1 new=$2 count=$3 tolerance=${4:-1e-6}
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
build/random-rotors "$count" | grep -v -e '--method rk4' >"$folder/options"
results() { # PROGRAM TOLERANCE: number of the rotor, key and value
  local n=0 options failed
  while read -r options; do
    echo "rotor $((++n))"
    # shellcheck disable=SC2001,SC2086
    "$1" run $(sed "s/--tolerance [^ ]*/--tolerance $2/" <<<"$options") --json 2>/dev/null && failed=no || failed=yes
    echo "failed $failed"
  done <"$folder/options" | awk '
    /^rotor / { n = $2; of_run = 1 }
    /"remarks"/ { of_run = 0 }
    of_run && NF || /^failed/ { sub(",$", ""); print n, $1, $2 }'
}
results "$old" 1e-11 >"$folder/old"
different() { # NAME: rows and results that differ from the old ones
  LC_ALL=C awk -v tolerance="$tolerance" -v name="$1" '
    NR == FNR { of_old[$1, $2] = $3; next }
    ($1, $2) in of_old {
      a = of_old[$1, $2]; b = $3
      if (a == b || a + 0 == a && b + 0 == b && (a - b)^2 <= tolerance^2*(a^2 > b^2 ? a^2 : b^2)) next
      if (!($1 in rows)) { rows[$1]; ++count; first = first == "" ? $1 ": " $2 " " a " " b : first }
    }
    END {
      printf "%d rotors, %d rows differ %s%s\n", $1, count, name, count ? ", the first: " first : "" >"/dev/stderr"
      print count + 0
    }
  ' "$folder/old" -
}
of_tolerance=$(results "$old" 1e-12 | different "between 1e-11 and 1e-12")
of_program=$(results "$new" 1e-11 | different "between the programs")
[ "$of_program" -le "$of_tolerance" ]
