#!/usr/bin/env bash
# What `make explore` does first: compiles the engine for the browser. The page embeds it.
set -euo pipefail
work=$1/explore
command -v em++ >/dev/null || { echo "Without em++, which make deps-explore installs." >&2; exit 1; }
# A node other than Debian's does not find Debian's node-acorn.
export NODE_PATH=/usr/share/nodejs
mkdir -p "$work"
emcmake cmake --preset browser -B "$work" >"$work/cmake.log" 2>&1 || { cat "$work/cmake.log" >&2; exit 1; }
cmake --build "$work" --target engine | sed -u '/no work to do\|Re-checking/d'
