#!/usr/bin/env bash
# Makes the pictures of docs/reading_a_verdict.md: one per verdict, from cases of the stretcher's benchmark, and one of each thing
# that real scanners show, from cases of the scanner's benchmark; for the latter it also prints the page's figures.
#   make build && cmake --build build --target benchmarks && scripts/verdict_pictures.sh [PROGRAMS [seen]]     seen: only the latter
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

# seen NAME CASE [SEED]: draws a case of the scanner's benchmark, and prints its figures
seen() {
  local picture="$images/seen_$1.png" chosen=(--cases "$2" --seed "${3:-1}")
  "$programs/bench_scanner_views" "${chosen[@]}" --write "$work"
  [ "$1" = torn_piece ] && clean_scan
  draw accepted
  figures "${chosen[@]}"
}

# Cleans the scan as it came, by the tool.
clean_scan() {
  "$programs/../cloud_preprocess/clean_cloud" --input "$work/scan.ply" --output "$work/object.ply" --grid off
}

# figures OPTIONS of the benchmark...: what stretch said of the files in the work folder, and how far off the truth it is
figures() {
  python3 - "$work/report.json" <<'END'
import json, sys
report = json.load(open(sys.argv[1]))
for key in ("message", "overlap", "inlier_ratio", "rms", "deformation_nodes", "inferred_waypoints", "waypoints_in_air",
            "largest_displacement", "largest_expected_error_normal", "largest_expected_error_tangential",
            "largest_expected_error_angle"):
    if key in report:
        print(f"  {key}: {report[key]:.5g}" if isinstance(report[key], float) else f"  {key}: {report[key]}")
END
  env -u SCAN_CELL_DATA "$programs/bench_scanner_views" --only-ours "$@" | grep -A 2 '^| case'
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
    --report "$work/report.json" "${adapted[@]}" "${leaf[@]}" --output "${picture:-$images/verdict_$reason.png}"
  echo "${picture:-$images/verdict_$reason.png}"
}

# What scanners really see
seen closed_mesh 'moved: pipe elbow'
seen mixed_points 'moved: ribbed bracket'
seen torn_piece 'in a scene, cleaned: stepped block' 3
seen orientation 'moved: stepped block'
seen bent 'bent: casing'
seen smooth 'moved: saddle shell'
seen in_the_air 'own path: sanded sheet, bent'
seen swollen 'warped, scan as reference: cast body'
[ "${2:-}" = seen ] && exit
show accepted 'frame, bent 5 mm'
show ambiguous 'symmetric box'
show path_not_scanned 'frame, three quarters scanned'
show wrong_part 'wrong part: other moulding'
show scale_at_bound 'frame, x 0.38'
show tolerance_exceeded 'frame, bent 5 mm' --method affine
"$programs/bench_scanner_views" --cases 'bent: blade' --write "$work"
draw position_uncertain --max-position-error 0.002
leaf=(--leaf 0.02 0.02 0.02)
show too_few_points 'frame, as it is'
leaf=()

# A path of another frame: 200 mm off
"$programs/bench_tool_path_stretcher" --cases 'panel, turned' --write "$work"
awk -F, -v OFS=, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "y") y = i; print; next } { $y += 0.2; print }' \
  "$work/path.csv" >"$work/moved.csv"
mv "$work/moved.csv" "$work/path.csv"
draw path_off_reference
