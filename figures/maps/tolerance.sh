#!/usr/bin/env bash
# How far a map's outcomes depend on its tolerance, in one sentence: tolerance.sh ROTOR MAP.toml FOLDER
# Runs some of the map's points once more at the tolerance that a map has by default, and counts other outcomes.
set -euo pipefail
rotor=$1 map=$2 folder=$3 strict=1e-11
name=$folder/$(basename "$map" .toml)-some
own=$(sed -n 's/^tolerance = //p' "$map")
for tolerance in "$own" $strict; do
  sed -e 's/^points = 400$/points = 50/; s/^points = 40$/points = 7/' -e "s/^tolerance = .*/tolerance = $tolerance/" \
    "$map" >"$name-$tolerance.toml"
  "$rotor" sweep "$name-$tolerance.toml" --force --out "$name-$tolerance.csv" >/dev/null 2>"$name.log" || { cat "$name.log" >&2; exit 1; }
done
without_texts() { sed '/^#/d; s/"[^"]*"/-/g' "$1"; }    # which may have commas
paste -d, <(without_texts "$name-$own.csv") <(without_texts "$name-$strict.csv") | LC_ALL=C awk -F, -v own="$own" -v strict=$strict '
  NR == 1 { for (n = 1; n <= NF; ++n) if ($n == "outcome") place[++found] = n; next }
  { ++points; others += $place[1] != $place[2] }
  function power(of) { sub(/^1e/, "10^{", of); return of "}" }
  END { printf "tolerance %s; at %s, %.2g %% of %d points have another outcome\n", power(own), power(strict), 100*others/points, points }'
