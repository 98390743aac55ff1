#!/usr/bin/env bash
# sanitize.sh addresses   every test under AddressSanitizer, LeakSanitizer and UndefinedBehaviorSanitizer
# sanitize.sh threads     the tests of the cores that have threads under ThreadSanitizer
# Builds in a tree of its own, build-asan or build-tsan. What a sanitizer says of any process, of a node that no
# test looks at too, is left in TREE/reports or TREE/run.log, printed, and fails the run.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# Packages and their tests; with what they build on.
threaded_packages="scan_cell_common;scan_cell_msgs;c4g_driver;laser_trigger;tecnogamma_camera;pose_frame_binder"
threaded_packages+=";laser_triangulation;cloud_preprocess;tool_path_stretcher;scan_calibration;scan_cell;scan_cell_sim"
# package/name of test_package_name
threaded_tests=(scan_cell_common/core c4g_driver/core c4g_driver/with_emulator laser_trigger/core
  pose_frame_binder/core scan_cell/core scan_cell_sim/core scan_cell_sim/controller scan_cell_sim/camera
  tecnogamma_camera/core tecnogamma_camera/recordings tecnogamma_camera/aravis laser_triangulation/core
  cloud_preprocess/core scan_calibration/estimate scan_calibration/calibrate)

# nodelet itself is Debian's and loads our libraries late; the sanitizer's must be the first.
wrap_nodelet() {
  local folder=$tree/devel/lib/nodelet
  mkdir -p "$folder"
  printf '#!/bin/sh\nLD_PRELOAD=%s exec /usr/lib/nodelet/nodelet "$@"\n' "$(gcc -print-file-name=libasan.so)" \
    >"$folder/nodelet"
  chmod +x "$folder/nodelet"
}

addresses() {
  wrap_nodelet
  local common="log_path=$reports/report:print_stacktrace=1:halt_on_error=1"
  export ASAN_OPTIONS="$common:detect_stack_use_after_return=1:strict_string_checks=1:check_initialization_order=1"
  export UBSAN_OPTIONS="$common"
  export LSAN_OPTIONS="suppressions=$PWD/scripts/sanitizers/leaks.txt:print_suppressions=0"
  # Eigen has memory of its own under the sanitizer, which it must not: PCL's libraries free what we took.
  # -O2: the simulated cell must keep up with its pulses.
  make test BUILD=$tree DEVEL=$tree/devel CELLS=1 \
    FLAGS='-O2 -g1 -fno-omit-frame-pointer -fsanitize=address,undefined -fno-sanitize-recover=undefined -DEIGEN_MALLOC_ALREADY_ALIGNED=1 -Wno-maybe-uninitialized'
}

# One after another, each to its end: a test that fails must not hide what is found in the others.
threads() {
  export TSAN_OPTIONS="log_path=$reports/report:second_deadlock_stack=1"
  TSAN_OPTIONS+=":suppressions=$PWD/scripts/sanitizers/races.txt"
  make configure BUILD=$tree DEVEL=$tree/devel WHITELIST="$threaded_packages" \
    FLAGS='-O2 -g1 -fno-omit-frame-pointer -fsanitize=thread -Wno-tsan'
  local failed=() test target
  for test in "${threaded_tests[@]}"; do
    target=test_${test/\//_}
    echo "== $target"
    cmake --build $tree --parallel "${JOBS:-$(nproc)}" --target "$target" >"$tree/build.log" 2>&1 ||
      { tail -n 40 "$tree/build.log"; return 1; }
    # Without address randomization: ThreadSanitizer of this compiler does not know the layouts of some kernels.
    setarch --addr-no-randomize "$tree/devel/lib/${test%/*}/$target" --gtest_brief=1 || failed+=("$target")
  done
  [ ${#failed[@]} -eq 0 ] || { echo "FAILED under the thread sanitizer: ${failed[*]}"; return 1; }
}

case ${1:-} in
  addresses) tree=build-asan ;;
  threads) tree=build-tsan ;;
  *) sed -n '2,5s/^# //p' "$0" >&2; exit 2 ;;
esac
reports=$PWD/$tree/reports
rm -rf "$reports"
mkdir -p "$reports"
set +e
(set -e; "$1") 2>&1 | tee "$tree/run.log"
status=${PIPESTATUS[0]}
# This sanitizer keeps to the standard error, whatever it is told.
if grep -n -A 12 ': runtime error: ' "$tree/run.log"; then status=1; fi
for report in "$tree"/reports/*; do
  [ -e "$report" ] || continue
  status=1
  echo "== $report"
  head -n 60 "$report"
done
echo "sanitize $1: $([ $status -eq 0 ] && echo nothing found || echo "see above, and $tree/reports")"
exit $status
