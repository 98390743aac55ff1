// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

#include "scan_cell_common/files/outputs.h"

namespace scan_cell_common {

constexpr int kUnusable = 1;  //!< exit code of a tool: unusable input or machine
constexpr int kRefused = 2;   //!< exit code of a tool whose answer is no

/// The main() of a command-line tool: parses its options, answers --help and --version, removes
/// what an earlier run left in its outputs, runs `body`, and turns whatever it throws into one line
/// on standard error, `name: reason`. For an unknown option it suggests the nearest existing one;
/// the outputs are removed then, too.
/// @param refused exit code for Refused, for tools that distinguish a refusal from a failure
/// @param outputs of this tool
/// @return exit code: 0 for --help and --version, what `body` returns, or kUnusable, also for bad
/// options
int tool_main(const std::string& name, CLI::App& options, int argc, char** argv,
              const std::function<int()>& body, int refused = kUnusable,
              const Outputs& outputs = {});

}  // namespace scan_cell_common
