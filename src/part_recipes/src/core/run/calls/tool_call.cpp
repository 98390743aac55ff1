// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "run/calls/tool_call.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/process.hpp>
#include <chrono>
#include <csignal>
#include <thread>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"

namespace part_recipes {

namespace fs = std::filesystem;
namespace process = boost::process;

using scan_cell_common::FileError;

namespace {

/// Does not use wait_for(), which misses the end of a child if SIGCHLD comes between two calls or
/// to another thread (Boost 1.74).
void wait(process::child& child, const Stop& stop) {
  constexpr std::chrono::milliseconds kPeriod(20);  // a person notices 100 ms
  bool told = false;
  while (child.running()) {
    std::this_thread::sleep_for(kPeriod);
    if (told || !stop || !stop()) continue;
    kill(child.id(), SIGINT);
    told = true;
  }
}

}  // namespace

void add_options(ToolCall& call, const ToolOptions& options) {
  for (const auto& [name, value] : options) {
    if (value == "false") continue;
    std::string option = "--" + name;
    std::replace(option.begin(), option.end(), '_', '-');
    call.command.push_back(option);
    if (value != "true") call.command.push_back(value);
  }
}

fs::path program_of(const std::string& package, const std::string& tool) {
  const fs::path self = fs::read_symlink("/proc/self/exe");
  // PREFIX/lib/part_recipes/run beside PREFIX/lib/PACKAGE/TOOL
  fs::path program = self.parent_path().parent_path() / package / tool;
  if (!fs::exists(program))
    throw FileError(program.string(), "no such tool", "build the whole suite: make");
  return program;
}

StageRecord run_tool(const ToolCall& call, const fs::path& folder, const fs::path& log,
                     const Stop& stop) {
  const auto start = std::chrono::steady_clock::now();
  StageRecord record{call.stage, call.command, 0, 0};
  const fs::path program = program_of(call.package, call.command.front());
  const std::vector<std::string> arguments(call.command.begin() + 1, call.command.end());
  try {
    process::child child(
        process::exe = program.string(), process::args = arguments,
        process::start_dir = folder.string(),
        process::std_in<process::null, (process::std_out & process::std_err)> log.string());
    wait(child, stop);
    record.exit_code = child.exit_code();
  } catch (const process::process_error& error) {
    throw FileError(program.string(), error.what(), "check that it can be run");
  }
  record.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return record;
}

std::string last_line(const fs::path& log) {
  std::string text = scan_cell_common::read_file(log.string());
  const std::size_t end = text.find_last_not_of(" \r\n\t");
  if (end == std::string::npos) return "";
  text.resize(end + 1);
  const std::size_t start = text.find_last_of("\r\n");
  return start == std::string::npos ? text : text.substr(start + 1);
}

}  // namespace part_recipes
