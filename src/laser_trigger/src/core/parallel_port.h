// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "laser_trigger/trigger_port.h"
#include "scan_cell_common/net/descriptor.h"

namespace laser_trigger {

/// A PC's parallel port through Linux' ppdev. The claim is taken at the first write and held, so no
/// other program can change the lines meanwhile. The kernel releases it when the process dies for
/// any reason, but does not clear the data register: that is the guardian's task.
class ParallelPort : public TriggerPort {
 public:
  /// @throw NoDevice, NoPermission
  explicit ParallelPort(const std::string& device);
  ~ParallelPort() override;
  ParallelPort(const ParallelPort&) = delete;
  ParallelPort& operator=(const ParallelPort&) = delete;

  /// Claims the port unless it is already claimed.
  /// @throw DeviceBusy if another program holds it for longer than `timeout` [s]
  void claim(double timeout);

  void write(std::uint8_t data) override;

 private:
  std::string device_;
  scan_cell_common::Descriptor descriptor_;
  bool claimed_ = false;
};

}  // namespace laser_trigger
