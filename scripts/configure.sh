#!/usr/bin/env bash
# configure.sh TREE DEVEL ARGUMENT...   runs cmake for a build tree and catkin's workspace DEVEL. It takes 15 s, so not
# again with the same arguments and packages: if a file that cmake reads changes, ninja runs it by itself.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

tree=$1 devel=$2
shift 2
# catkin stores the environment of the first configure for the tests, and leaves out directories that do not exist yet.
mkdir -p "$tree" "$devel/lib/pkgconfig" "$devel/lib/python3/dist-packages"
command=(cmake -S src -B "$tree" -G Ninja -DCATKIN_DEVEL_PREFIX="$(realpath "$devel")" "$@")
# In the workspace, whose setup.bash cmake writes: who deletes one of the two gets both.
done_before=$devel/.configured
wanted="$(printf '%s\n' "${command[@]}" src/*/package.xml)"
if [ -e "$tree/build.ninja" ] && [ "$(cat "$done_before" 2>/dev/null)" = "$wanted" ]; then exit 0; fi
rm -f "$done_before"
"${command[@]}" >"$tree/configure.log" 2>&1 || {
  cat "$tree/configure.log"
  exit 1
}
echo "$wanted" >"$done_before"
