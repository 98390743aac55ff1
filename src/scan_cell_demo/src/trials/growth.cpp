// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "trials/growth.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "scan_cell_common/errors/errors.h"

namespace scan_cell_demo {

namespace fs = std::filesystem;

namespace {

using Iterator = std::vector<Holdings>::const_iterator;

struct Mean {
  double value = 0;
  double deviation = 0;  // of the mean
};

Mean mean_memory(Iterator begin, Iterator end) {
  const auto count = static_cast<double>(end - begin);
  double sum = 0, squares = 0;
  for (Iterator i = begin; i != end; ++i)
    sum += i->memory;
  for (Iterator i = begin; i != end; ++i)
    squares += std::pow(i->memory - sum / count, 2);
  return {sum / count, std::sqrt(squares / (count - 1) / count)};
}

int maximum(Iterator begin, Iterator end, int Holdings::*what) {
  return (*std::max_element(
             begin, end,
             [what](const Holdings& a, const Holdings& b) { return a.*what < b.*what; })).*
         what;
}

}  // namespace

Holdings holdings_of(pid_t process) {
  const std::string folder = fmt::format("/proc/{}", process);
  Holdings holdings;
  std::ifstream status(folder + "/status");
  for (std::string line; std::getline(status, line);) {
    double kilobytes = 0;
    if (std::sscanf(line.c_str(), "VmRSS: %lf kB", &kilobytes) == 1)
      holdings.memory = kilobytes * 1024 / 1e6;
    std::sscanf(line.c_str(), "Threads: %d", &holdings.threads);
  }
  if (holdings.threads == 0)
    throw scan_cell_common::FileError(folder, "no such process", "see the log of its node");
  for (const auto& entry : fs::directory_iterator(folder + "/fd")) {
    std::error_code gone;  // a descriptor may be closed meanwhile
    const std::string target = fs::read_symlink(entry.path(), gone);
    if (gone) continue;
    ++holdings.files;
    if (target.rfind("socket:", 0) == 0) ++holdings.sockets;
  }
  return holdings;
}

std::string growth(const std::vector<Holdings>& samples) {
  constexpr std::size_t kMinSamples = 6;
  if (samples.size() < kMinSamples)
    throw scan_cell_common::Refused("verdict", fmt::format("only {} samples", samples.size()),
                                    "run for longer");
  const Iterator last = samples.end() - static_cast<std::ptrdiff_t>(samples.size() / 3);
  const Iterator before = last - static_cast<std::ptrdiff_t>(samples.size() / 3);
  const Mean then = mean_memory(before, last), now = mean_memory(last, samples.end());
  constexpr double kMinGrowth = 1, kShare = 0.01, kDeviations = 4;  // [MB]; chosen
  const double scatter = kDeviations * std::hypot(then.deviation, now.deviation);
  std::string grown;
  if (now.value - then.value > std::max({kMinGrowth, kShare * then.value, scatter}))
    grown += fmt::format(" memory {:.1f} -> {:.1f} MB", then.value, now.value);
  const std::pair<const char*, int Holdings::*> counts[] = {{"threads", &Holdings::threads},
                                                            {"files", &Holdings::files},
                                                            {"sockets", &Holdings::sockets}};
  for (const auto& [name, what] : counts) {
    const int had = maximum(before, last, what), has = maximum(last, samples.end(), what);
    if (has > had) grown += fmt::format(" {} {} -> {}", name, had, has);
  }
  return grown;
}

}  // namespace scan_cell_demo
