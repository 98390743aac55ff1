#!/usr/bin/env bash
# teach_cell.sh FOLDER   finds tool and world of the simulated cell from poses that the cell records while somebody
# touches points with the tool's tip, and writes FOLDER/cell.yaml. Starts a cell of its own at ROS_MASTER_URI.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
folder=$(realpath "$1")
# shellcheck disable=SC1091
set +u && source devel/setup.bash && set -u

rm -f "$folder"/{tool_poses.csv,world_poses.csv,cell.yaml}
roslaunch launch/calibration.launch sim:=true >"$folder/teach.log" 2>&1 &
cell=$!
trap 'kill -INT $cell 2>/dev/null; wait $cell 2>/dev/null || true' EXIT
rosrun scan_cell_sim touch_points.py --cell src/scan_cell_sim/config/cell.yaml --output "$folder"
rosrun scan_calibration cell_frames tool --poses "$folder/tool_poses.csv" --cell "$folder/cell.yaml"
rosrun scan_calibration cell_frames world --points "$folder/world_poses.csv" --cell "$folder/cell.yaml"
