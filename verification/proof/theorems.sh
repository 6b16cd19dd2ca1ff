#!/usr/bin/env bash
# Repeats the commands of the table of proven values, and rewrites its rows.
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
