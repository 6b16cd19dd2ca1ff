#!/usr/bin/env bash
# What `make verify` does once everything is built: runs the tests, prints and saves the report, and runs
# random rotors. The status is 0 if everything passes.
set -uo pipefail
build=$1
report=$build/report
data=reference-data
mkdir -p "$report"
failed=0
verification/tests.sh "$build" verification || failed=1
"$build/report-numbers" $data "$report" | tee "$report/report.txt" || failed=1
"$build/random-rotors" 200 "$report" | tee -a "$report/report.txt" || failed=1
echo
echo "This report: $report/report.txt"
# The reviewer's page, if its pictures have been drawn.
drawn=1
for scene in figures/paper/fig[0-9][0-9].toml; do
  [ -e "$build/figures/$(basename "$scene" .toml).svg" ] || drawn=0
done
if [ $drawn = 1 ]; then
  verification/report/report.sh "$build" || failed=1
fi
exit $failed
