#!/usr/bin/env bash
# Runs the stretcher's benchmark and writes its figures to docs/stretcher_benchmark.md. Use an idle machine, with
# SCAN_CELL_DATA set, after: make build && cmake --build build --target benchmarks
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
page=docs/stretcher_benchmark.md
figures="$(mktemp)"
trap 'rm -f "$figures"' EXIT
"${1:-devel/lib/tool_path_stretcher/bench_tool_path_stretcher}" | tee "$figures"
sed -i '/^<!-- figures -->$/q' "$page"
echo >>"$page"
cat "$figures" >>"$page"
