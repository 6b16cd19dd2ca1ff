#!/usr/bin/env bash
# How far a map's outcomes depend on its tolerance, in one sentence: tolerance.sh BUILD MAP.toml FOLDER
# Runs some of the map's points once more at the tolerance that a map has by default, and counts other outcomes.
set -euo pipefail
build=$1 map=$2 folder=$3 strict=1e-11
name=$folder/$(basename "$map" .toml)-some
own=$(sed -n 's/^tolerance = //p' "$map")
for tolerance in "$own" $strict; do
  sed -e 's/^points = 400$/points = 50/; s/^points = 40$/points = 7/' -e "s/^tolerance = .*/tolerance = $tolerance/" \
    "$map" >"$name-$tolerance.toml"
  "$build/rotor" sweep "$name-$tolerance.toml" --force --out "$name-$tolerance.csv" >/dev/null 2>"$name.log" ||
    { cat "$name.log" >&2; exit 1; }
done
others=$("$build/map-statistics" others "$name-$own.csv" "$name-$strict.csv")
echo "tolerance 10^{${own#1e}}; at 10^{${strict#1e}}, $others have another outcome"
