// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell/progress_bar.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace scan_cell {

ProgressBar::ProgressBar(const std::string& title)
    : title_(title), terminal_(isatty(STDERR_FILENO) != 0) {}

ProgressBar::~ProgressBar() {
  if (terminal_ && last_tenth_ >= 0) std::fputc('\n', stderr);
}

void ProgressBar::show(const std::string& what, double progress) {
  constexpr int kWidth = 24;  // characters; chosen
  const double share = std::clamp(progress, 0.0, 1.0);
  const int filled = static_cast<int>(std::lround(share * kWidth));
  const int percent = static_cast<int>(std::lround(share * 100));
  const std::string bar = std::string(static_cast<std::size_t>(filled), '#') +
                          std::string(static_cast<std::size_t>(kWidth - filled), '.');
  if (terminal_) {
    std::fprintf(stderr, "\r\033[K%s [%s] %3d %% %s", title_.c_str(), bar.c_str(), percent,
                 what.c_str());
  } else if (percent / 10 != last_tenth_) {
    std::fprintf(stderr, "%s [%s] %3d %% %s\n", title_.c_str(), bar.c_str(), percent, what.c_str());
  }
  last_tenth_ = percent / 10;
  std::fflush(stderr);
}

}  // namespace scan_cell
