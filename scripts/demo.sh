#!/usr/bin/env bash
# Runs the whole cell without hardware: scans a reference and a changed part, adapts the tool path, traces it with the
# tool, and compares both with the ground truth. Writes clouds, paths, picture and report to out/. Tool and world are those that were taught in
# the simulated cell just before, not the simulator's own.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck disable=SC1091
set +u && source devel/setup.bash && set -u

out="$PWD/out"
mkdir -p "$out"
rm -f "$out"/*.ply "$out"/*.csv "$out"/*.png "$out"/*.json "$out"/*.bag "$out"/cell.yaml

export ROS_IP=127.0.0.1 ROS_HOME="$out/ros"
export ROS_MASTER_URI="http://127.0.0.1:${DEMO_MASTER_PORT:-11321}"  # not the master of a cell that may be running
rviz=false
[ -n "${DISPLAY:-}" ] && rviz=true

echo "Teaching tool and world (log: out/teach.log)"
scripts/teach_cell.sh "$out" || { tail -n 25 "$out/teach.log" >&2; exit 1; }

echo "Starting the simulated cell (log: out/cell.log)"
roslaunch --wait launch/scan_cell.launch sim:=true rviz:=$rviz record:="$out/demo.bag" \
  cell:="$out/cell.yaml" settings:="$PWD/src/scan_cell_demo/config/demo.yaml" >"$out/cell.log" 2>&1 &
cell=$!
roscore -p "${DEMO_MASTER_PORT:-11321}" >"$out/roscore.log" 2>&1 &
core=$!
trap 'kill -INT $cell 2>/dev/null; wait $cell 2>/dev/null; kill -INT $core 2>/dev/null; wait $core 2>/dev/null || true' EXIT

status=0
rosrun scan_cell_demo demo --output "$out" || status=$?
if [ "$status" -eq 0 ] || [ "$status" -eq 3 ]; then
  rosrun scan_cell_demo plot_result.py --reference "$out/reference.ply" --object "$out/object.ply" \
    --path "$out/tool_path.csv" --adapted "$out/adapted_path.csv" --truth "$out/true_path.csv" --traced "$out/traced_path.csv" \
    --output "$out/result.png"
  echo "Results in out/: $(cd "$out" && ls ./*.ply ./*.csv ./*.png ./*.json | sed 's,^./,,' | tr '\n' ' ')"
else
  echo "The demo failed; the last lines of the cell's log:" >&2
  tail -n 25 "$out/cell.log" >&2
fi
exit "$status"
