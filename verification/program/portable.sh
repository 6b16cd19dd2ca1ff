#!/usr/bin/env bash
# What `make portable` does: builds the program for aarch64, runs it in an emulator, and compares its
# results for the paper's three rubs with those of this machine, to the last bit, estimated digits included.
set -euo pipefail
build=$1
for needed in aarch64-linux-gnu-g++ qemu-aarch64; do
  command -v $needed >/dev/null || { echo "Without $needed, which make deps-portable installs." >&2; exit 1; }
done
cmake -S . -B "$build/aarch64" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_SYSTEM_NAME=Linux \
  -DCMAKE_SYSTEM_PROCESSOR=aarch64 -DCMAKE_CXX_COMPILER=aarch64-linux-gnu-g++ \
  -DCMAKE_PREFIX_PATH="$(printf "%s;" /usr/lib/"$(gcc -print-multiarch)"/cmake/*/)" -DROTOR_HEADERS_ONLY=ON \
  -DROTOR_VERIFICATION=OFF >"$build/aarch64.log" || { cat "$build/aarch64.log" >&2; exit 1; }
cmake --build "$build/aarch64" --target rotor
for friction in 0.3 0.2 0.08; do
  for method in event rk4; do
    arguments=(run --friction $friction --method $method --json)
    diff <("$build/rotor" "${arguments[@]}") \
      <(qemu-aarch64 -L /usr/aarch64-linux-gnu "$build/aarch64/rotor" "${arguments[@]}") ||
      { echo "mu = $friction, $method: differs" >&2; exit 1; }
    echo "mu = $friction, $method: the same to the last bit"
  done
done
estimated() { "$@" run --start-speed-Hz 150 --until 0.02 --equations published --digits "$digits"; }
for digits in 6 12; do
  diff <(estimated "$build/rotor") <(estimated qemu-aarch64 -L /usr/aarch64-linux-gnu "$build/aarch64/rotor") ||
    { echo "$digits digits: differ" >&2; exit 1; }
  echo "$digits digits: the same"
done
