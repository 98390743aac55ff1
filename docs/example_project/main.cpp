// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause

/// Adapts a tool path to a scanned object and prints the verdict, as a program of your own would.
#include <scan_cell_common/errors/errors.h>
#include <tool_path_stretcher/stretcher.h>
#include <tool_path_stretcher/surface.h>
#include <tool_paths/tool_path_files.h>

#include <iostream>

namespace ts = tool_path_stretcher;

int main(int argc, char** argv) {
  if (argc != 5) {
    std::cerr << "usage: adapt_my_path REFERENCE.ply OBJECT.ply PATH.csv ADAPTED.csv\n";
    return 1;
  }
  try {
    const ts::StretchParameters parameters;  // the same defaults as the command and the node
    const ts::Surface reference = ts::load_surface(argv[1], parameters.leaf);
    const ts::Surface object = ts::load_surface(argv[2], parameters.leaf);
    const ts::ToolPath path = tool_paths::load_tool_path(argv[3]);

    const ts::StretchResult result = ts::stretch(reference, object, path, parameters);
    if (!result.verdict.accepted()) {
      std::cout << "refused (" << to_string(result.verdict.reason)
                << "): " << result.verdict.message << "\n";
      return 2;
    }
    tool_paths::save_tool_path(argv[4], result.path);
    std::cout << "accepted: scale " << result.similarity.scale << ", "
              << waypoint_count(result.path) << " waypoints, rms " << 1e3 * result.rms << " mm\n";
    return 0;
  } catch (const scan_cell_common::Error& error) {
    std::cerr << error.thing() << ": " << error.value() << "; " << error.cure() << "\n";
    return 1;
  }
}
