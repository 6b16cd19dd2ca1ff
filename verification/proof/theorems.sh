#!/usr/bin/env bash
# Repeats the commands of the table of what is proven, and writes its rows anew.
set -euo pipefail
prove=$1
table=$2
done=0
mapfile -t commands < <(sed -n 's/.*,build\/prove //p' "$table" | uniq)
{
  sed '/^quantity,/q' "$table"
  for options in "${commands[@]}"; do
    echo "proving [$((++done))/${#commands[@]}]: $options" >&2
    "$prove" $options || { echo "$table is left as it was" >&2; exit 1; }
  done
} >"$prove.csv"
mv "$prove.csv" "$table"
