#!/usr/bin/env bash
# Draws a picture, whole or not at all: draw.sh OUTPUT SETTINGS SCRIPT...
# How OUTPUT ends, .svg, .pdf or .png, is its format; SETTINGS are gnuplot's, beside those that style.gp
# wants. The user's locale and settings for gnuplot change no picture.
set -euo pipefail
output=$1 settings=$2
shift 2
export LC_ALL=C.UTF-8
trap 'rm -f "$output.part"' EXIT
gnuplot -d -e "output = '$output.part'; format = '${output##*.}'; \
  printed_inputs = '$(dirname "$0")/../reference-data/printed-inputs.csv'; $settings" \
  "$(dirname "$0")/paper/style.gp" "$@"
# gnuplot does not report a full disk: a picture is whole if its end is there.
if ! tail -c 16 "$output.part" | grep -aq '</svg>\|%%EOF\|IEND'; then
  echo "$output: gnuplot has not drawn the whole picture" >&2
  exit 1
fi
# Browsers smooth the cells of maps into colours that mean nothing, unless a style forbids it.
[ "${output##*.}" != svg ] || sed -i "s/<image /<image style='image-rendering:pixelated' /" "$output.part"
mv "$output.part" "$output"
echo "$output"
