#!/usr/bin/env bash
# What `make lint` does: checks that all scripts can be called by their names, that the wrong changes by hand
# of `make mutants` compile, the format of all sources, and model/ and figures/ by clang-tidy (see .clang-tidy).
# cppcheck was tried and found no real fault.
set -uo pipefail
build=$1/lint
failed=""
while IFS= read -rd '' file; do
  [ "$(head -zc 2 "$file")" = '#!' ] && script=yes || script=no
  [ -x "$file" ] && mode=yes || mode=no
  [ $script = $mode ] || { echo "$file: starts with #!: $script; may be run: $mode" >&2; failed=1; }
done < <(git ls-files -z)
[ -z "$failed" ] || exit 1
python3 -B verification/robustness/mutants.py --check || exit 1
mapfile -t all < <(git ls-files '*.cpp' '*.hpp' '*.ipp')
clang-format --dry-run -Werror "${all[@]}" || exit 1

# All sources of a folder at once, because the headers of libraries take longest; without gcc's
# precompiled headers and quadruple precision.
cmake --preset release -B "$build" -DROTOR_VERIFICATION=OFF -DHAS_QUADMATH=OFF \
  -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON >"$build.log" 2>&1 ||
  { cat "$build.log" >&2; exit 1; }
# With this name clang's analyzer also follows paths in the included sources.
for file in "$build"/CMakeFiles/*/Unity/unity_*; do mv "$file" "${file/unity_/UnifiedSource_}"; done
sed -i 's/unity_/UnifiedSource_/g' "$build/compile_commands.json"
# The analyzer follows fewer paths than by default, which takes half the time; planted faults are found still.
paths=(-Xclang -analyzer-config -Xclang max-nodes=60000)
sed -n 's/.*"file": "\(.*\)".*/\1/p' "$build/compile_commands.json" | grep -v '/digits.dir/\|/version.dir/' |
  xargs -d '\n' -P "$(nproc)" -n 1 clang-tidy -p "$build" --quiet --warnings-as-errors='*' \
    --checks=-bugprone-suspicious-include "${paths[@]/#/--extra-arg=}" 2>/dev/null
