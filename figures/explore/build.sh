#!/usr/bin/env bash
# What `make explore` does: compiles the engine for the browser and makes one file of the page.
set -euo pipefail
build=$1
here=$(dirname "$0")
work=$build/explore
for needed in em++ node npm; do
  command -v $needed >/dev/null || { echo "Without $needed, which make deps-explore installs." >&2; exit 1; }
done
# A node that is not Debian's does not look where Debian keeps node-acorn.
export NODE_PATH=/usr/share/nodejs
mkdir -p "$work/npm" "$build/report"
emcmake cmake --preset browser -B "$work" >"$work/cmake.log" 2>&1 || { cat "$work/cmake.log" >&2; exit 1; }
cmake --build "$work" --target engine | sed -u '/no work to do\|globbed directories/d'
if ! cmp -s "$here/package-lock.json" "$work/npm/package-lock.json"; then
  cp "$here"/package{,-lock}.json "$work/npm/"
  npm ci --prefix "$work/npm" --ignore-scripts --no-audit --no-fund --silent ||
    { rm "$work/npm/package-lock.json"; exit 1; }
fi
node "$here/bundle.mjs" "$work" "$build/report/explore.html"
echo "$build/report/explore.html"
