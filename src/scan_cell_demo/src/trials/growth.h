// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace scan_cell_demo {

/// What a process holds at one time.
struct Holdings {
  double memory = 0;  //!< [MB] resident
  int threads = 0;
  int files = 0;  //!< descriptors, sockets among them
  int sockets = 0;
};

/// @throw scan_cell_common::FileError if there is no such process
Holdings holdings_of(pid_t process);

/// Whether a process that does the same again and again holds more and more. The first third of
/// the samples is taken as its warming up; the last third is compared with the one before. Memory
/// has grown where its mean is above by more than 1 MB, 1 % and four times what the scatter of the
/// samples explains; threads, files and sockets where there are ever more than before.
/// @return what has grown; empty: nothing, the process is flat
/// @throw scan_cell_common::Refused for fewer than six samples
std::string growth(const std::vector<Holdings>& samples);

}  // namespace scan_cell_demo
