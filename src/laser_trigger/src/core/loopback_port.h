// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "laser_trigger/trigger_port.h"
#include "scan_cell_common/net/descriptor.h"

namespace laser_trigger {

/// The simulator's trigger circuit: each write is one UDP datagram of one byte, the data register.
class LoopbackPort : public TriggerPort {
 public:
  /// @param host IPv4 address
  /// @throw scan_cell_common::InvalidParameter if it is not one
  LoopbackPort(const std::string& host, std::uint16_t port);
  void write(std::uint8_t data) override;

 private:
  std::string name_;
  scan_cell_common::Descriptor socket_;
};

}  // namespace laser_trigger
