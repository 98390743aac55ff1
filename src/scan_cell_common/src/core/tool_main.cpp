// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/tool_main.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "scan_cell_common/errors.h"

namespace scan_cell_common {

int tool_main(const std::string& name, CLI::App& options, int argc, char** argv,
              const std::function<int()>& body, int refused) {
  const auto fail = [&name](const std::exception& error, int code) {
    std::fflush(stdout);
    std::fprintf(stderr, "%s: %s\n", name.c_str(), error.what());
    return code;
  };
  try {
    options.parse(argc, argv);
    return body();
  } catch (const CLI::ParseError& error) {
    return options.exit(error) == 0 ? 0 : kUnusable;
  } catch (const Refused& error) {
    return fail(error, refused);
  } catch (const std::exception& error) {
    return fail(error, kUnusable);
  }
}

}  // namespace scan_cell_common
