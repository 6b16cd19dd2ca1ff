#!/usr/bin/env bash
# What `make report` does once everything is built and drawn: collects the files of the page in a folder,
# and writes the page: report.sh BUILD
set -euo pipefail
build=$1 out=$1/report
rm -rf "$out/figures"
mkdir -p "$out/figures/published" "$out/figures/consistent"
cp "$build"/figures/fig[0-9][0-9].svg "$out/figures"
for set in published consistent; do cp "$build/figures/$set"/fig[0-9][0-9].csv "$out/figures/$set"; done
# The coarse map of the first screen, made again if program or map have changed.
map=$build/maps/page
mkdir -p "$map"
sed 's/^points = 400$/points = 60/' figures/maps/speed-friction.toml >"$map/map.toml"
[ "$map/map.csv" -nt "$build/rotor" ] && [ "$map/map.csv" -nt figures/maps/speed-friction.toml ] ||
  "$build/rotor" sweep "$map/map.toml" --out "$map/map.csv"
cp "$map/map.csv" "$out"
rm -f "$out/engine.wasm.gz.base64"
[ ! -e "$build/explore/engine.wasm" ] ||
  gzip --no-name --best --stdout "$build/explore/engine.wasm" | base64 -w 0 >"$out/engine.wasm.gz.base64"
# Unexpected verdicts fail `make verify`, not the page, which shows them.
"$build/report-numbers" reference-data "$out" >/dev/null || true
(cd "$out" && sha256sum claims.csv map.csv figures/*/*.csv >SHA256SUMS)
date=$(git show -s --format=%cs HEAD 2>/dev/null || echo unknown)
"$build/report-page" . "$build" "$out" "$date"
rm -f "$out/engine.wasm.gz.base64"
echo "$out/index.html"
