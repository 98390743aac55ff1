// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace scan_cell_demo {

/// Resources of a process at one time.
struct Holdings {
  double memory = 0;  //!< [MB] resident
  int threads = 0;
  int files = 0;  //!< descriptors, including sockets
  int sockets = 0;
};

/// @throw scan_cell_common::FileError if there is no such process
Holdings holdings_of(pid_t process);

/// Whether a process that repeats the same work uses ever more resources. The first third of the
/// samples is the warm-up; the last third is compared with the second. Memory has grown if its mean
/// is higher by more than 1 MB, 1 % and four times what the scatter of the samples explains;
/// threads, files and sockets if their maximum is higher.
/// @return what has grown; empty: nothing
/// @throw scan_cell_common::Refused for fewer than six samples
std::string growth(const std::vector<Holdings>& samples);

}  // namespace scan_cell_demo
