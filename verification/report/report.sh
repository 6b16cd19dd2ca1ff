#!/usr/bin/env bash
# What `make report` does once everything is built and drawn: collects the files of the page in a folder,
# and writes the page: report.sh BUILD [engine]
set -euo pipefail
build=$1 engine=${2:-} out=$1/report
mkdir -p "$out"
# The map of the first screen.
map=$build/maps/60/speed-friction
cp "$map.csv" "$out/map.csv"
# Its lines: each begins with its set of equations and its number; empty lines part its points.
gnuplot -e "theory = '$map-theory.csv'; panels = 2; forms = 5; along_x(v) = v; along_y(v) = v" figures/maps/lines.gp \
  -e "set print '-'; do for [p = 1:2] { do for [i = 1:forms] { \
    print 'line ', word('published corrected', p), i; eval sprintf('print \$line_%d_%d', p - 1, i) } }" >"$out/lines.txt"
rm -f "$out/engine.wasm.gz.base64"
[ -z "$engine" ] ||
  gzip --no-name --best --stdout "$build/explore/engine.wasm" | base64 -w 0 >"$out/engine.wasm.gz.base64"
# Unexpected verdicts fail `make verify`, not the page, which shows them.
"$build/report-numbers" reference-data "$out" >/dev/null || true
figures/draw.sh "$out/claims.svg" "data = '$out/claims.csv'" verification/paper/claims.gp >/dev/null
"$build/report-page" . "$build" "$out"
rm -f "$out/engine.wasm.gz.base64"
echo "$out/index.html"
