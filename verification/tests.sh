#!/usr/bin/env bash
# tests.sh BUILD PROGRAM [NAMES]: runs the tests of a program in a build folder, or those with such names, on
# all cores, quietly: failures and skipped tests are shown with their messages. Results of all, the program
# `verification`, are BUILD/report/tests-*.json.
set -uo pipefail
build=$1 program=$2
results=$build/report/${program/#verification/tests}
mkdir -p "$build/report"
rm -f "$results"-*.json
# Nothing may depend on what the user exports: which tests run, how, and in which locale.
unset "${!GTEST_@}" "${!ROTOR_@}"
export LC_ALL=C GTEST_TOTAL_SHARDS=$(nproc) GTEST_BRIEF=1
pids=()
for ((shard = 0; shard < GTEST_TOTAL_SHARDS; ++shard)); do
  GTEST_SHARD_INDEX=$shard "$build/$program" --gtest_filter="${3:-*}" --gtest_output="json:$results-$shard.json" &
  pids+=($!)
done
status=0
for ((shard = 0; shard < GTEST_TOTAL_SHARDS; ++shard)); do
  wait "${pids[shard]}" || status=1
  [ -e "$results-$shard.json" ] || {  # tests that crashed count as one that failed
    status=1
    echo '{"testsuites": [{"testsuite": [{"classname": "Tests", "name": "EndAtTheirTime",
      "file": "tests.sh", "time": "0s",
      "result": "COMPLETED",
      "failures": [{"failure": "they crashed"}]}]}]}' >"$results-$shard.json"
  }
done
count() { cat "$results"-*.json | grep -c "$1"; }
failed=$(count '"failures": \[')
passed=$(($(count '"result": "COMPLETED"') - failed))
[ $passed -gt 0 ] || status=1
echo "$passed passed, $failed failed, $(count '"result": "SKIPPED"') skipped"
exit $status
