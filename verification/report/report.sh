#!/usr/bin/env bash
# What `make report` does once everything is built and drawn: collects the files of the page in a folder,
# and writes the page: report.sh BUILD [engine]
set -euo pipefail
build=$1 engine=${2:-} out=$1/report
mkdir -p "$out"
# The coarse map of the first screen, made again if program or map have changed.
map=$build/maps/page
mkdir -p "$map"
sed 's/^points = 400$/points = 60/' figures/maps/speed-friction.toml >"$map/map.toml"
[ "$map/map.csv" -nt "$build/rotor" ] && [ "$map/map.csv" -nt figures/maps/speed-friction.toml ] ||
  "$build/rotor" sweep "$map/map.toml" --force --out "$map/map.csv"
cp "$map/map.csv" "$out"
"$build/map-theory" figures/maps/speed-friction.toml >"$map/theory.csv"
# Its lines, as JSON: parts with their set of equations, their number and points.
gnuplot -e "theory = '$map/theory.csv'; rows = 1; forms = 5; along_x(v) = v; along_y(v) = v" figures/maps/lines.gp \
  -e "set print '-'; do for [p = 1:2] { do for [i = 1:forms] { \
    print 'line ', word('published corrected', p), i; eval sprintf('print \$line_%d_%d', p - 1, i) } }" | awk '
  /^line/ { set = $2; line = $3 - 1; next }
  NF == 3 && !/#/ { printf "%s[%s,%s]", begun++ ? "," : (parts++ ? ",\n" : "[") "{\"set\":\"" set "\",\"line\":" line ",\"points\":[", $1, $2; next }
  begun { printf "]}"; begun = 0 }
  END { print begun ? "]}]" : "]" }' >"$out/lines.json"
rm -f "$out/engine.wasm.gz.base64"
[ -z "$engine" ] ||
  gzip --no-name --best --stdout "$build/explore/engine.wasm" | base64 -w 0 >"$out/engine.wasm.gz.base64"
# Unexpected verdicts fail `make verify`, not the page, which shows them.
"$build/report-numbers" reference-data "$out" >/dev/null || true
date=$(git show -s --format=%cs HEAD 2>/dev/null || echo unknown)
"$build/report-page" . "$build" "$out" "$date"
rm -f "$out/engine.wasm.gz.base64"
echo "$out/index.html"
