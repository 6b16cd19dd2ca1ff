#!/usr/bin/env bash
# Computes the figures' data of a set of equations, in one process, and replaces what differs:
#   data.sh ROTOR published|corrected FOLDER
# Unchanged data keep their time stamp, so that their pictures are not drawn again.
set -euo pipefail
rotor=$1 equations=$2 folder=$3
mkdir -p "$folder"
new=$(mktemp -d "$folder/new.XXXXXX")
trap 'rm -rf "$new"' EXIT
"$rotor" figure --scenes figures/paper --equations "$equations" --out "$new" 2>&1 | sed '/^data of .* written$/d' >&2
for file in "$new"/*; do
  cmp -s "$file" "$folder/${file##*/}" || mv "$file" "$folder"
done
