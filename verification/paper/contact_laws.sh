#!/bin/sh
# What `make contact-laws` does: computes the table, and draws the rings of contact-laws.csv at mu = 0.3: contact_laws.sh BUILD
set -e
build=$1 folder=$1/contact-laws-traces
"$build/contact-laws" reference-data 100
mkdir -p "$folder"
grep '^published,0.3,' reference-data/contact-laws.csv |
  while IFS=, read -r _ _ same exponent k_t deepest_um _; do
    "$build/rotor" run --equations published --friction 0.3 --contact-stiffness "$k_t" \
      --contact-exponent "$exponent" --reference-indentation "${deepest_um:-0}e-6" \
      --from 29.104 --until 29.152 --columns time_s,normal_force_N --trace "$folder/$same-$exponent.csv" >"$folder/run.txt"
  done
figures/draw.sh verification/paper/contact-laws.svg "folder = '$folder'" verification/paper/contact-laws.gp
