// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace scan_cell_common {

/// A program that ends with this object, or with the process that started it.
class ChildProcess {
 public:
  /// @param command program (searched on PATH) and its arguments
  /// @param quiet discards its output
  /// @throw Refused if it cannot be started
  explicit ChildProcess(const std::vector<std::string>& command, bool quiet = false);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  pid_t id() const { return id_; }  //!< of the process
  int wait();                       ///< @return its exit code; 128 + the signal that ended it

 private:
  pid_t id_ = -1;
};

/// Resources used by a process so far.
struct Usage {
  double cpu = 0;     //!< [s]
  double memory = 0;  //!< [MB] resident
};

/// Processor time and memory of a process on this machine.
Usage usage_of(pid_t process);
double cpu_of_this_thread();  ///< [s]

/// A free TCP port of 127.0.0.1, for a private ROS master.
/// @throw Refused if there is none
int free_port();

}  // namespace scan_cell_common
