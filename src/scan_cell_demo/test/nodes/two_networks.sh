#!/usr/bin/env bash
# two_networks.sh FOLDER   in a network namespace of its own: scans with robot, camera and trigger circuit (the
# simulator) in a second one, at the far end of a virtual cable. Leaves part.ply and the logs in FOLDER.
set -euo pipefail
folder=$1
root=$(realpath "$(dirname "${BASH_SOURCE[0]}")/../../../..")
here=10.77.0.1 there=10.77.0.2
sim=$(rospack find scan_cell_sim)/config
unset ROS_HOSTNAME  # each side says its address by ROS_IP
export ROS_MASTER_URI=http://$here:11311 ROS_HOME=$folder/ros

unshare --net sleep infinity &
hardware=$!
launched=()
end() {
  for job in "${launched[@]}"; do kill -INT -- -"$job" && wait "$job"; done
  kill $hardware
} 2>/dev/null
trap end EXIT
until [ "$(readlink /proc/$hardware/ns/net)" != "$(readlink /proc/$$/ns/net)" ]; do sleep 0.05; done
on_hardware() { nsenter --target $hardware --net "$@"; }

ip link add name lan type veth peer name lan netns $hardware
ip link set lo up
ip address add $here/24 dev lan
ip link set lan mtu 9000 up
on_hardware ip link set lo up
on_hardware ip address add $there/24 dev lan
on_hardware ip link set lan mtu 9000 up

cat >"$folder/settings.yaml" <<SETTINGS
laser_trigger: {port: loopback, loopback_host: $there}
scan_cell: {unseen_after: 0.5}
camera: {packet_size: 9000, region_x: 336, region_y: 599, region_width: 1024, region_height: 512,
  device_clock: host, exposure: 0.001}
SETTINGS
set -m  # a process group each
ROS_IP=$here roslaunch "$root/launch/scan_cell.launch" scanner:="$sim/calibrated_scanner.yaml" \
  cell:="$sim/cell.yaml" controller:=$there camera:=$there camera_latency:=0.0 \
  settings:="$folder/settings.yaml" >"$folder/cell.log" 2>&1 &
launched+=($!)
ROS_IP=$there on_hardware roslaunch --wait "$root/launch/simulator.launch" world:="$sim/reference_frame.yaml" \
  scanner:="$sim/scanner.yaml" cell:="$sim/cell.yaml" address:=$there >"$folder/simulator.log" 2>&1 &
launched+=($!)

export ROS_IP=$here
until rostopic list 2>/dev/null | grep -q /scan_cell_sim/parts; do sleep 0.5; done
for _ in {1..20}; do  # until robot and camera are up, it refuses
  rosrun scan_cell scan --program "$(rospack find scan_cell)/config/scan_line.yaml" --timeout 30 \
    --clean "$folder/part.ply" >"$folder/scan.log" 2>&1 && break
  sleep 1
done
rosrun scan_cell_sim ground_truth cloud --world "$sim/reference_frame.yaml" --part frame \
  --cloud "$folder/part.ply" --json "$folder/judged.json"
