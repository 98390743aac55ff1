// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

#include "scan_cell_common/files/outputs.h"

namespace scan_cell_common {

constexpr int kUnusable = 1;  //!< exit code of a tool: input or machine are of no use
constexpr int kRefused = 2;   //!< exit code of a tool whose answer is no

/// The main() of a command-line tool: parses its options, answers --help and --version, removes
/// what an earlier run left in its outputs, runs `body`, and turns whatever that throws into one
/// line on the standard error output, `name: reason`. An unknown option is told with the nearest
/// one that there is; the outputs are removed then, too.
/// @param refused exit code for Refused, of tools that tell a no from a failure
/// @param outputs of this tool
/// @return exit code: 0 for --help and --version, what `body` returns, or kUnusable, also for bad
/// options
int tool_main(const std::string& name, CLI::App& options, int argc, char** argv,
              const std::function<int()>& body, int refused = kUnusable,
              const Outputs& outputs = {});

}  // namespace scan_cell_common
