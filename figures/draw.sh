#!/usr/bin/env bash
# Draws a picture, whole or not at all: draw.sh OUTPUT SETTINGS SCRIPT...
# The extension of OUTPUT, .svg, .pdf or .png, is its format; SETTINGS are for gnuplot, besides those that
# style.gp needs. The user's locale and gnuplot settings have no effect.
set -euo pipefail
output=$1 settings=$2 figures=${0%/*}
shift 2
export LC_ALL=C.UTF-8
trap 'rm -f "$output.part" "$output.once"' EXIT
gnuplot -d -e "output = '$output.part'; format = '${output##*.}'; \
  reference_data = '$figures/../reference-data'; $settings" "$figures/paper/style.gp" "$@"
# gnuplot does not report a full disk: a picture is complete if it has its end.
if ! tail -c 16 "$output.part" | grep -aq '</svg>\|%%EOF\|IEND'; then
  echo "$output: gnuplot did not draw the whole picture" >&2
  exit 1
fi
# gnuplot does not escape "]]>", leaves it to the renderer whether spaces beside indices are kept, and draws
# boxed labels twice, the first time by a filter: one of them with a white edge remains. Tenths of a pixel are
# enough for long curves. Without these styles renderers blend the cells of maps into meaningless colours.
if [ "${output##*.}" = svg ]; then
  sed -i "s/<image /<image style='image-rendering:pixelated' /g; s/<polygon /<polygon shape-rendering='crispEdges' /g; s/<text>/<text xml:space=\"preserve\">/; s/]]>/]]\&gt;/g
    /^[[:space:]]*L[0-9]/s/\(\.[0-9]\)[0-9]\>/\1/g" "$output.part"
  awk 'match($0, /<g transform="[^"]*"/) {
      group = $0; place = substr($0, RSTART, RLENGTH); getline
      if (group ~ /url\(#textbox\)/) {
        boxed[place $0] = 1; getline
        if (sub(/\t<g transform.*/, "", group)) print group
        next
      }
      if ((place $0) in boxed)
        sub(/stroke="none"/, "stroke=\"white\" stroke-width=\"5\" stroke-linejoin=\"round\" paint-order=\"stroke\"", group)
      print group
    }
    { print }' "$output.part" >"$output.once"
  mv "$output.once" "$output.part"
fi
mv "$output.part" "$output"
echo "$output"
