#!/usr/bin/env bash
# Makes each change of mutants.txt in a copy of the sources, builds the tests there and runs them. A
# change that no test notices is a hole in the tests: it is named, and the status is 1. Which test
# notices which change is in build/mutants/mutants.csv; tests that noticed none are listed at the end.
set -euo pipefail
cd "$(dirname "$0")/../.."
source=$PWD
work=$source/build/mutants
rm -rf "$work" && mkdir -p "$work/tree"
cp -r CMakeLists.txt model figures verification reference-data "$work/tree"

# Little optimisation: building takes longer than running.
cmake -S "$work/tree" -B "$work/build" -G Ninja -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_FLAGS=-O1 \
  -DROTOR_WARNINGS_AS_ERRORS=OFF >"$work/log"
run_tests() { # names of the failed tests
  RC_PARAMS=seed=1 timeout 300 "$work/build/verification" --gtest_output="json:$work/result.json" \
    >"$work/log" 2>&1 && return
  sed -n 's/^\[  FAILED  \] \([A-Za-z0-9_\/.]*\).*(.*ms)$/\1/p' "$work/log" | sort -u
  [ -s "$work/result.json" ] || echo "(ended before its time)"
}

cmake --build "$work/build" --target verification >"$work/log" || { cat "$work/log"; exit 1; }
"$work/build/verification" --gtest_list_tests |
  awk '/^[^ ]/ { suite = $1 } /^  / { print suite $1 }' | grep -F . | sort >"$work/idle"
[ -z "$(run_tests)" ] || { echo "The tests fail without any change." >&2; exit 1; }

report=$work/mutants.csv
echo "file,change,caught_by,tests" >"$report"
survivors=0 count=0
while IFS='@' read -r file from to what; do
  trim() { sed 's/^ *//; s/ *$//' <<<"$1"; }
  file=$(trim "$file") from=$(trim "$from") to=$(trim "$to") what=$(trim "$what")
  count=$((count + 1))
  cp "$source/$file" "$work/tree/$file"
  FROM=$from TO=$to perl -0pi -e 'BEGIN { $hits = 0 } $hits += s/\Q$ENV{FROM}\E/$ENV{TO}/;
    END { exit($hits ? 0 : 3) }' "$work/tree/$file" ||
    { echo "$file: there is no \"$from\"; mutants.txt is out of date" >&2; exit 1; }
  rm -f "$work/result.json"
  if cmake --build "$work/build" --target verification >"$work/log" 2>&1; then
    failed=$(run_tests)
  else
    echo "$file: \"$to\" does not compile; see $work/log" >&2; exit 1
  fi
  number=$(grep -c . <<<"$failed" || true)
  [ "$number" -gt 0 ] || survivors=$((survivors + 1))
  printf '%-48s %s\n' "$what" "$([ "$number" -gt 0 ] && echo "caught by $number, first $(head -1 <<<"$failed")" || echo "NOT CAUGHT")"
  echo "$file,$what,$number,$(tr '\n' ' ' <<<"$failed")" >>"$report"
  comm -23 "$work/idle" <(sort <<<"$failed") >"$work/log" && mv "$work/log" "$work/idle"
  cp "$source/$file" "$work/tree/$file"
done < <(grep -v '^#' verification/robustness/mutants.txt)
echo "$count changes, $survivors not caught; tests that noticed none of them:"
sed 's/^/  /' "$work/idle"
[ "$survivors" -eq 0 ]
