#!/bin/bash
# libfuzzer.sh READER [options of libFuzzer]   fuzzes one reader with clang's libFuzzer and its address and
# undefined-behaviour sanitizers (Debian: clang, libclang-rt-dev). READER is a target of fuzz_cloud_files,
# fuzz_tool_path_files, fuzz_surfaces, fuzz_c4g_datagrams or fuzz_videe_lines. Its findings are left in build/libfuzzer/READER.
set -euo pipefail
cd "$(dirname "$0")/.."
reader=${1:?which reader: ply ply_mesh pcd point_table depth_profiles stl obj csv csv_angles yaml yaml_angles cloud_surface mesh_surface raw answers requests parameters videe}
shift
common=src/scan_cell_common
stretcher=src/tool_path_stretcher
paths=src/tool_paths
driver=src/c4g_driver
simulator=src/scan_cell_sim
cell=src/scan_cell
shopt -s globstar
sources=($common/src/core/{clouds,clock,errors,files,net,pose,tools}/*.cpp $common/src/testing/{fuzzing,fuzz_main}.cpp)
case $reader in
  ply | ply_mesh | pcd | point_table | depth_profiles | stl | obj) program=$common/test/clouds/fuzz_cloud_files.cpp
    sources+=($common/test/clouds/cloud_file_targets.cpp) ;;
  raw | answers | requests | parameters) program=$driver/test/wire/fuzz_c4g_datagrams.cpp
    sources+=($driver/src/core/wire/*.cpp $driver/test/wire/c4g_datagram_targets.cpp $simulator/src/core/controller/**/*.cpp) ;;
  videe) program=$cell/test/videe/fuzz_videe_lines.cpp
    sources+=($cell/src/core/videe/videe_command.cpp $cell/test/videe/videe_line_targets.cpp) ;;
  *_surface) program=$stretcher/test/fuzz_surfaces.cpp
    sources+=($stretcher/src/core/{geometry,surface}/*.cpp $stretcher/test/surface_targets.cpp) ;;
  *) program=$paths/test/path/fuzz_tool_path_files.cpp
    sources+=($paths/src/core/**/*.cpp $paths/test/path/tool_path_file_targets.cpp) ;;
esac
folder=build/libfuzzer/$reader
rm -rf "$folder/objects"
mkdir -p "$folder/objects" "$folder/corpus"
flags=(-std=c++17 -O1 -g -DSUITE_VERSION=\"fuzzed\" -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=undefined
  -fsanitize-ignorelist=scripts/sanitizers/libfuzzer.txt
  -I "$common/include" -I "$stretcher/include" -I "$stretcher/src/core" -I "$common/src/core" -I "$paths/include" -I "$paths/src/core" -I "$driver/include" -I "$driver/src/core"
  -I "$simulator/include" -I "$simulator/src/core" -I "$cell/include" -I "$cell/src/core"
  -I "$common/test" -I "$driver/test" -I "$cell/test" -I "$paths/test" -I "$stretcher/test" -isystem /usr/include/liblzf -isystem /usr/include/kdl -isystem /usr/include/eigen3 -isystem "$(echo /usr/include/pcl-*)")
printf '%s\n' "${sources[@]}" | xargs -P "$(nproc)" -I{} bash -c \
  'clang++ "$@" -c {} -o "'"$folder"'/objects/$(tr / _ <<<{}).o"' _ "${flags[@]}"
link=("$folder"/objects/*.o -lpcl_common -llzf -lyaml-cpp -lorocos-kdl)
clang++ "${flags[@]}" "$program" "${link[@]}" -fsanitize=address,undefined -o "$folder/seeds"
clang++ "${flags[@]}" -DLIBFUZZER "$program" "${link[@]}" -fsanitize=fuzzer,address,undefined -o "$folder/fuzz"
"$folder/seeds" --target "$reader" --seeds "$folder/corpus"
FUZZ_TARGET=$reader exec "$folder/fuzz" -artifact_prefix="$folder/" "$@" "$folder/corpus"
