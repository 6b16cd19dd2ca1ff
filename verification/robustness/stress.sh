#!/usr/bin/env bash
# What `make stress` does once the programs are built: stress.sh BUILD RUNS SEED
set -euo pipefail
build=$1 runs=$2 seed=$3
mkdir -p "$build/stress-results"
"$build/random-rotors" 5000 "$build/stress-results"
"$build/random-digits" "$runs" "$seed"
