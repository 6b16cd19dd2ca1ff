#!/usr/bin/env bash
# What `make verify` does once everything is built: runs the tests, prints and saves the report, and runs
# random rotors. The status is 0 if everything passes.
set -uo pipefail
build=$1
report=$build/report
data=reference-data
mkdir -p "$report"
failed=0
verification/tests.sh "$build" verification | tee "$report/tests.txt" || failed=1
"$build/report-numbers" $data "$report" | tee "$report/report.txt" || failed=1
"$build/random-rotors" 200 "$report" | tee -a "$report/report.txt" || failed=1

# The answer.
echo
echo "Tests: $(tail -n 1 "$report/tests.txt")"
grep -E '^(equations as printed|corrected equations|refuted, [a-z ]*): ' "$report/report.txt"
echo "Everything: $report/report.txt; one claim: make claim ID=energy_kept"
exit $failed
