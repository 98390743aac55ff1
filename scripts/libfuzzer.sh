#!/usr/bin/env bash
# libfuzzer.sh PROGRAM READER [options of libFuzzer]   fuzzes one reader with clang's libFuzzer and its address and
# undefined-behaviour sanitizers (Debian: clang, libclang-rt-dev). PROGRAM is one of make fuzz: fuzz_cloud_files,
# fuzz_robot_programs ...; its --help lists the readers. Builds in build-libfuzzer; findings are left in
# build-libfuzzer/READER.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
program=${1:?which program of make fuzz} reader=${2:?which of its readers}
shift 2
tree=build-libfuzzer
folder=$PWD/$tree/$reader
mkdir -p "$folder/corpus"

# The seeds come from the program as make fuzz runs it.
make configure
cmake --build build --parallel "$(nproc)" --target "$program"
build=(devel/lib/*/"$program")
"${build[0]}" --target "$reader" --seeds "$folder/corpus"

CXX=clang++ CC=clang make configure BUILD=$tree DEVEL=$tree/devel \
  FLAGS="-O1 -g -DLIBFUZZER -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=undefined \
-fsanitize-ignorelist=$PWD/scripts/sanitizers/libfuzzer.txt"
cmake --build $tree --parallel "$(nproc)" --target "$program"
instrumented=("$tree"/devel/lib/*/"$program")
FUZZ_TARGET=$reader exec "${instrumented[0]}" -artifact_prefix="$folder/" "$@" "$folder/corpus"
