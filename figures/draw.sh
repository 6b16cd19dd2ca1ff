#!/usr/bin/env bash
# Draws a picture, whole or not at all: draw.sh OUTPUT SETTINGS SCRIPT...
# The extension of OUTPUT, .svg, .pdf or .png, is its format; SETTINGS are for gnuplot, besides those that
# style.gp needs. The user's locale and gnuplot settings have no effect.
set -euo pipefail
output=$1 settings=$2 figures=${0%/*}
shift 2
export LC_ALL=C.UTF-8
trap 'rm -f "$output.part"' EXIT
gnuplot -d -e "output = '$output.part'; format = '${output##*.}'; \
  reference_data = '$figures/../reference-data'; $settings" "$figures/paper/style.gp" "$@"
# gnuplot does not report a full disk: a picture is complete if it has its end.
if ! tail -c 16 "$output.part" | grep -aq '</svg>\|%%EOF\|IEND'; then
  echo "$output: gnuplot did not draw the whole picture" >&2
  exit 1
fi
# gnuplot does not escape "]]>", and without this style browsers blend the cells of maps into meaningless colours.
[ "${output##*.}" != svg ] || sed -i "s/<image /<image style='image-rendering:pixelated' /g; s/]]>/]]\&gt;/g" "$output.part"
mv "$output.part" "$output"
echo "$output"
