// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

namespace CLI {
class App;
}

namespace scan_cell_common {

constexpr int kUnusable = 1;  //!< exit code of a tool: input or machine are of no use
constexpr int kRefused = 2;   //!< exit code of a tool whose answer is no

/// The main() of a command-line tool: parses its options, runs `body`, and turns whatever that
/// throws into one line on the standard error output, `name: reason`.
/// @param refused exit code for Refused, of tools that tell a no from a failure
/// @return exit code: 0 for --help, what `body` returns, or kUnusable, also for bad options
int tool_main(const std::string& name, CLI::App& options, int argc, char** argv,
              const std::function<int()>& body, int refused = kUnusable);

}  // namespace scan_cell_common
