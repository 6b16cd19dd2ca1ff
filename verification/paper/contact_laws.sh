#!/bin/sh
# Draws the rings of contact-laws.csv at mu = 0.3: contact_laws.sh ROTOR FOLDER
set -e
rotor=$1 folder=$2
mkdir -p "$folder"
grep '^published,0.3,' reference-data/contact-laws.csv |
  while IFS=, read -r _ _ same exponent damping k_t deepest_um alpha _; do
    [ "$damping" = dashpot ] && d_t=10000 || d_t=0
    "$rotor" run --equations published --friction 0.3 --contact-stiffness "$k_t" --contact-damping $d_t \
      --contact-exponent "$exponent" --reference-indentation "${deepest_um:-0}e-6" --contact-hysteresis "$alpha" \
      --from 29.104 --until 29.152 --columns time_s,normal_force_N --trace "$folder/$same-$exponent-$damping.csv" >"$folder/run.txt"
  done
figures/draw.sh verification/paper/contact-laws.svg "folder = '$folder'" verification/paper/contact-laws.gp
