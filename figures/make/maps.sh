#!/usr/bin/env bash
# Draws the maps with this number of points along each axis: maps.sh BUILD POINTS FORMAT [-jN]
set -euo pipefail
build=$1 points=$2 format=$3
[ "$points" -ge 20 ] || { echo "POINTS=$points: must be at least 20" >&2; exit 1; }
[ "$points" = 400 ] || mkdir -p "$build/maps/$points" # by which CMake knows of it
exec figures/make/build.sh "$build" ${4:-} --without-digits "maps-$points-$format"
