#!/bin/bash
# libfuzzer.sh READER [options of libFuzzer]   fuzzes one reader with clang's libFuzzer and its address and
# undefined-behaviour sanitizers (Debian: clang, libclang-rt-dev). READER is a target of fuzz_cloud_files,
# fuzz_tool_path_files, fuzz_c4g_datagrams or fuzz_videe_lines. What it finds stays in build/libfuzzer/READER.
set -euo pipefail
cd "$(dirname "$0")/.."
reader=${1:?which reader: ply pcd stl obj csv yaml cloud_surface mesh_surface raw answers requests parameters videe}
shift
common=src/scan_cell_common
stretcher=src/tool_path_stretcher
driver=src/c4g_driver
simulator=src/scan_cell_sim
cell=src/scan_cell
sources=($common/src/core/{cloud_files,errors,files,mesh_files,pcd_file,ply_file,text}.cpp
  $common/src/fuzzing/{fuzzing,fuzz_main}.cpp)
case $reader in
  ply | pcd | stl | obj) program=$common/test/fuzz_cloud_files.cpp
    sources+=($common/test/cloud_file_targets.cpp) ;;
  raw | answers | requests | parameters) program=$driver/test/fuzz_c4g_datagrams.cpp
    sources+=($driver/src/core/{build,parse,seal,wire_units}.cpp $driver/test/c4g_datagram_targets.cpp
    $common/src/core/timed_pose.cpp $simulator/src/core/controller/*.cpp) ;;
  videe) program=$cell/test/fuzz_videe_lines.cpp
    sources+=($cell/src/core/videe_command.cpp $cell/test/videe_line_targets.cpp) ;;
  *) program=$stretcher/test/fuzz_tool_path_files.cpp
    sources+=($stretcher/src/core/{kd_tree,mesh_sampling,number_text,points,surface,tool_path}.cpp
    $stretcher/src/core/tool_path_{csv,files,yaml}.cpp
    $stretcher/test/tool_path_file_targets.cpp) ;;
esac
folder=build/libfuzzer/$reader
rm -rf "$folder/objects"
mkdir -p "$folder/objects" "$folder/corpus"
flags=(-std=c++17 -O1 -g -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=undefined
  -fsanitize-ignorelist=scripts/sanitizers/libfuzzer.txt
  -I "$common/include" -I "$stretcher/include" -I "$stretcher/src/core" -I "$driver/include"
  -I "$simulator/include" -I "$cell/include" -isystem /usr/include/kdl -isystem /usr/include/eigen3 -isystem "$(echo /usr/include/pcl-*)")
printf '%s\n' "${sources[@]}" | xargs -P "$(nproc)" -I{} bash -c \
  'clang++ "$@" -c {} -o "'"$folder"'/objects/$(basename {} .cpp).o"' _ "${flags[@]}"
link=("$folder"/objects/*.o -lpcl_common -lpcl_io -lyaml-cpp -lorocos-kdl)
clang++ "${flags[@]}" "$program" "${link[@]}" -fsanitize=address,undefined -o "$folder/seeds"
clang++ "${flags[@]}" -DLIBFUZZER "$program" "${link[@]}" -fsanitize=fuzzer,address,undefined -o "$folder/fuzz"
"$folder/seeds" --target "$reader" --seeds "$folder/corpus"
FUZZ_TARGET=$reader exec "$folder/fuzz" -artifact_prefix="$folder/" "$@" "$folder/corpus"
