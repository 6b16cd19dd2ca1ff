#!/usr/bin/env bash
# Runs the tests of a build folder on all cores, quietly: failures and skipped tests are shown with their
# messages. Their results are BUILD/report/tests-*.json.
set -uo pipefail
build=$1
report=$build/report
mkdir -p "$report"
rm -f "$report"/tests-*.json
# The plainest locale: nothing may depend on that of the user.
export LC_ALL=C RC_PARAMS=seed=1 GTEST_TOTAL_SHARDS=$(nproc) GTEST_BRIEF=1
pids=()
for ((shard = 0; shard < GTEST_TOTAL_SHARDS; ++shard)); do
  GTEST_SHARD_INDEX=$shard "$build/verification" --gtest_output="json:$report/tests-$shard.json" &
  pids+=($!)
done
status=0
for ((shard = 0; shard < GTEST_TOTAL_SHARDS; ++shard)); do
  wait "${pids[shard]}" || status=1
  results=$report/tests-$shard.json
  [ -e "$results" ] || {  # tests that crashed count as one that failed
    status=1
    echo '{"testsuites": [{"testsuite": [{"classname": "Tests", "name": "EndAtTheirTime",
      "file": "tests.sh", "time": "0s",
      "result": "COMPLETED",
      "failures": [{"failure": "they crashed"}]}]}]}' >"$results"
  }
done
count() { cat "$report"/tests-*.json | grep -c "$1"; }
failed=$(count '"failures": \[')
echo "$(($(count '"result": "COMPLETED"') - failed)) passed, $failed failed, $(count '"result": "SKIPPED"') skipped"
exit $status
