#!/usr/bin/env bash
# Draws a picture, whole or not at all: draw.sh OUTPUT SETTINGS SCRIPT...
# The extension of OUTPUT, .svg, .pdf or .png, is its format; SETTINGS are for gnuplot, besides those that
# style.gp needs. The user's locale and gnuplot settings have no effect.
set -euo pipefail
output=$1 settings=$2 figures=${0%/*} part=$1.$$ # of this process
shift 2
export LC_ALL=C.UTF-8
trap 'rm -f "$part" "$part.once"' EXIT
gnuplot -d -e "output = '$part'; format = '${output##*.}'; \
  figures = '$figures'; reference_data = '$figures/../reference-data'; $settings" "$figures/paper/style.gp" "$@" || {
  status=$?
  [ $status = 127 ] || echo "$output: not drawn by $*: gnuplot's message above has the script and its line" >&2
  exit $status
}
# gnuplot does not report a full disk: a picture is complete if it has its end.
if ! tail -c 16 "$part" | grep -aq '</svg>\|%%EOF\|IEND'; then
  echo "$output: gnuplot did not draw the whole picture" >&2
  exit 1
fi
# gnuplot does not escape "]]>", leaves it to the renderer whether spaces beside indices are kept, and draws
# boxed labels twice, the first time by a filter: one of them with a white edge remains. Without these styles renderers
# blend the cells of maps into meaningless colours. Paths get steps of a tenth of a pixel, and lose the points that lie
# within that of the line.
if [ "${output##*.}" = svg ]; then
  sed -zi "s/<image /<image style='image-rendering:pixelated' /g; s/<polygon /<polygon shape-rendering='crispEdges' /g
    s/<text>/<text xml:space=\"preserve\">/g; s/]]>/]]\&gt;/g; s/<g [^>]*>\n<\/g>\n//g; s/<title>[^<]*<\/title>\|<desc>[^<]*<\/desc>//g" \
    "$part"
  awk '
    function tenths(n, text) { text = sprintf("%g", n/10); sub(/^0\./, ".", text); sub(/^-0\./, "-.", text); return text }
    function step(dx, dy, down) { down = tenths(dy); return tenths(dx) (down ~ /^-/ ? "" : ",") down }
    function passes(a, b, i, dx, dy, u, v, along, off, square) {
      dx = x[b] - x[a]; dy = y[b] - y[a]; square = dx*dx + dy*dy
      for (i = a + 1; i < b; ++i) {
        u = x[i] - x[a]; v = y[i] - y[a]; along = u*dx + v*dy; off = u*dy - v*dx
        if (along < 0 || along > square || off*off > square || !square && (u || v)) return 0
      }
      return 1
    }
    function add(text, more, n, at) {    # to words, the first count of which are a path
      more = split(text, parts, " ")
      for (n = 1; n <= more; ++n) {
        words[++count] = parts[n]
        if (split(substr(parts[n], 2), at, ",") == 2) { x[count] = int(10*at[1] + 0.5); y[count] = int(10*at[2] + 0.5) }
      }
    }
    function print_short(n, last) {
      for (n = 1; n <= count; ++n) {
        if (words[n] ~ /^M/) printf "M%s", step(x[n], y[n])
        else if (words[n] ~ /^Z/) { printf "Z"; continue }
        else if (n < count && words[n + 1] ~ /^L/ && n - last < 40 && passes(last, n + 1)) continue
        else printf "%s%s", n % 40 ? "l" : "\nl", step(x[n] - x[last], y[n] - y[last])
        last = n
      }
    }
    !/<path id=/ && (at = index($0, " d=\047")) {    # the shapes of points stay
      printf "%s", substr($0, 1, at + 3); $0 = substr($0, at + 4)
      for (count = 0; !(end = index($0, "\047")) && (getline line) > 0; $0 = line) add($0)
      add(substr($0, 1, end - 1)); print_short(); $0 = substr($0, end)
    }
    match($0, /<g transform="[^"]*"/) {
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
    { print }' "$part" >"$part.once"
  mv "$part.once" "$part"
fi
mv "$part" "$output"
echo "$output"
