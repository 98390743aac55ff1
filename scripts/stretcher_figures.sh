#!/usr/bin/env bash
# Runs the stretcher's benchmarks and writes what they print to docs/stretcher_figures.md. Use an idle machine, with
# SCAN_CELL_DATA set, after: make build && cmake --build build --target benchmarks
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
page=docs/stretcher_figures.md
figures="$(mktemp)"
trap 'rm -f "$figures"' EXIT
{
  echo "# Figures of the stretcher's benchmark"
  echo
  echo "Written by \`scripts/stretcher_figures.sh\` at commit $(git rev-parse --short HEAD), $(date -u +%F), on" \
    "$(nproc) processors. [The benchmark](stretcher_benchmark.md) says what the columns mean."
  for bench in bench_tool_path_stretcher bench_scanner_views bench_drawn_parts; do
    echo
    echo "## $bench"
    echo
    "devel/lib/tool_path_stretcher/$bench"
  done
} | tee "$figures"
cp "$figures" "$page"
