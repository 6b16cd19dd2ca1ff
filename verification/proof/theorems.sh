#!/usr/bin/env bash
# Writes the table of what is proven anew. Every command makes the rows of one run.
set -euo pipefail
prove=$1
table=$2
{
  echo "# What is proven by ball arithmetic: each value lies between lower and upper. From \`make prove\`."
  echo "# Options are those of \`rotor run\`; --bits is the precision, --rounding the width of all inputs as a share of their"
  echo "# printed digits' rounding. Without it the inputs are the decimals as printed. cpu_s: of the whole run, one core."
  echo "quantity,lower,upper,bits,cpu_s,command"
  while read -r options; do
    "$prove" $options
  done <<'THEOREMS'
--start-speed-hz 150 --friction 0.3 --equations published --until 0.03 --bits 96
--start-speed-hz 150 --friction 0.3 --equations consistent --until 0.04 --bits 96
--start-speed-hz 150 --friction 0.3 --equations published --until 0.03 --bits 64 --rounding 3e-7
--start-speed-hz 150 --friction 0.3 --equations consistent --until 0.034 --bits 64 --rounding 3e-7
--start-speed-hz 75 --friction 0.3 --equations published --until 0.08 --bits 96
--start-speed-hz 75 --friction 0.3 --equations consistent --until 0.25 --bits 96
--start-speed-hz 75 --friction 0.3 --equations consistent --until 0.25 --bits 64 --rounding 0.23
--start-speed-hz 150 --friction 0.2 --equations published --until 0.05 --bits 128
--start-speed-hz 150 --friction 0.2 --equations consistent --until 0.05 --bits 128
--start-speed-hz 150 --friction 0.08 --equations published --until 0.25 --bits 128
--start-speed-hz 150 --friction 0.08 --equations consistent --until 0.25 --bits 128
--friction 0.3 --equations published --until 29.13 --bits 128
--friction 0.3 --equations consistent --until 29.135 --bits 128
--friction 0.2 --equations published --until 29.15 --bits 128
--friction 0.2 --equations consistent --until 29.15 --bits 128
THEOREMS
} >"$prove.csv"
mv "$prove.csv" "$table"
