#!/usr/bin/env bash
# What `make laws` does: runs the rotors of laws.toml with each of five seeds, and compares them with the closed forms
# in reference-data/laws.csv, and those of the first seed in a picture: laws.sh BUILD
set -euo pipefail
build=$1 out=$1/laws
mkdir -p "$out"
for seed in 1 2 3 4 5; do
  sed "s/^seed = 1$/seed = $seed/" verification/paper/laws.toml >"$out/$seed.toml"
  "$build/rotor" sweep "$out/$seed.toml" --force --out "$out/$seed.csv"
done
"$build/law-accuracy" reference-data/laws.csv "$out"/[1-5].csv
figures/draw.sh model/theory/parity.svg "data = '$out/1.csv'" verification/paper/laws.gp
