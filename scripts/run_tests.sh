#!/usr/bin/env bash
# run_tests.sh BUILD TESTS ROSTESTS   runs every test of a build and names the failures: TESTS in parallel, with browsers
# and schedulers among them, then ROSTESTS rostests in parallel, which mostly wait for their simulated cell. Each of them
# may take TEST_TIMEOUT seconds (1200). Tests that match LEFT_OUT, a regular expression, do not run.
set -uo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
build=$1 tests=$2 rostests=$3 status=0

run() {
  ctest --test-dir "$build" --output-on-failure --timeout "${TEST_TIMEOUT:-1200}" \
    ${LEFT_OUT:+--exclude-regex "$LEFT_OUT"} "$@" || status=1
}

rm -rf "$build/test_results"
run --tests-regex '_gtest_|_nosetests_' --parallel "$tests"
run --tests-regex _rostest_ --parallel "$rostests"

[ -z "${LEFT_OUT:-}" ] || echo "Not tested: $LEFT_OUT"
[ -n "${SCAN_CELL_DATA:-}" ] ||
  echo "Not tested: the real parts (set SCAN_CELL_DATA to the folder that holds parts/)"
catkin_test_results --all "$build/test_results" | awk '{ print }
  /^Summary:/ { printf "%d passed, %d failed, %d skipped\n", $2 - $4 - $6 - $8, $4 + $6, $8 }' || status=1
scripts/failed_tests.py "$build/test_results" || status=1
exit $status
