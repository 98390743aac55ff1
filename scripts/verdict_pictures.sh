#!/usr/bin/env bash
# Makes the pictures of docs/reading_a_verdict.md: one per verdict, from cases of the stretcher's benchmark.
#   make build && cmake --build build --target benchmarks && scripts/verdict_pictures.sh
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
programs="${1:-devel/lib/tool_path_stretcher}"
images=docs/images
leaf=()  # option of both programs; empty: their default
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT

# show REASON CASE [options of stretch...]: draws an unchanged case of the benchmark
show() {
  local reason=$1 case=$2
  shift 2
  "$programs/bench_tool_path_stretcher" --cases "$case" --write "$work"
  draw "$reason" "$@"
}

# draw REASON [options of stretch...]: draws the files in the work folder
draw() {
  local reason=$1 adapted=() found
  shift
  rm -f "$work/adapted.csv"
  "$programs/stretch" --reference "$work/reference.ply" --object "$work/object.ply" --path "$work/path.csv" \
    --output "$work/adapted.csv" --report "$work/report.json" "${leaf[@]}" "$@" >/dev/null 2>&1 || true
  found=$(python3 -c 'import json, sys; print(json.load(open(sys.argv[1]))["reason"])' "$work/report.json")
  if [ "$found" != "$reason" ]; then
    echo "verdict_pictures: expected $reason, got $found" >&2
    exit 1
  fi
  [ -f "$work/adapted.csv" ] && adapted=(--adapted "$work/adapted.csv")
  "$programs/picture" --reference "$work/reference.ply" --object "$work/object.ply" --path "$work/path.csv" \
    --report "$work/report.json" "${adapted[@]}" "${leaf[@]}" --output "$images/verdict_$reason.png"
  echo "$images/verdict_$reason.png"
}

# A path across openings and past the rim
"$programs/bench_scanner_views" --cases 'sanded sheet, bent' --write "$work"
draw accepted
mv "$images/verdict_accepted.png" "$images/verdict_accepted_in_the_air.png"
show accepted 'frame, bent 5 mm'
show ambiguous 'symmetric box'
show path_not_scanned 'frame, three quarters scanned'
show wrong_part 'wrong part: other moulding'
show scale_at_bound 'frame, x 0.38'
show tolerance_exceeded 'frame, bent 5 mm' --method affine
leaf=(--leaf 0.02 0.02 0.02)
show too_few_points 'frame, as it is'
leaf=()

# A path of another frame: 200 mm off
"$programs/bench_tool_path_stretcher" --cases 'panel, turned' --write "$work"
awk -F, -v OFS=, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "y") y = i; print; next } { $y += 0.2; print }' \
  "$work/path.csv" >"$work/moved.csv"
mv "$work/moved.csv" "$work/path.csv"
draw path_off_reference
