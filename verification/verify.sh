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
grep -E '^(equations as printed|corrected equations) ' "$report/report.txt"
for begin in 1 17; do # a row of a claim begins with its verdicts, as printed and corrected
  echo "Refuted by the claim's own rule, $([ $begin = 1 ] && echo as printed || echo corrected):$(awk -v begin=$begin '
    substr($0, begin, 7) == "refuted" { id = substr($0, 57); sub(/[,:].*/, "", id); if (!seen[id]++) printf " %s", id }
  ' "$report/report.txt")"
done
echo "Everything: $report/report.txt; one claim: make claim ID=energy_kept"
exit $failed
