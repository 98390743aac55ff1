// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "scan_cell_common/errors/errors.h"

namespace scan_cell_common {
class ParameterTable;
}

namespace laser_trigger {

/// Bits of the trigger circuit's data register.
constexpr std::uint8_t kCameraPulse = 1;  //!< the camera's line
constexpr std::uint8_t kLaser0 = 2;       //!< laser_0
constexpr std::uint8_t kLaser1 = 4;       //!< laser_1

/// The register's laser bits for a mask as in TriggerEvent (bit 0: laser_0, bit 1: laser_1).
constexpr std::uint8_t laser_bits(std::uint8_t lasers) {
  return static_cast<std::uint8_t>(lasers << 1);
}

/// The port does not exist or is of another kind.
class NoDevice : public scan_cell_common::ConnectionError {
 public:
  using ConnectionError::ConnectionError;
};

/// The user may not use the port.
class NoPermission : public scan_cell_common::ConnectionError {
 public:
  using ConnectionError::ConnectionError;
};

/// Another program holds the port.
class DeviceBusy : public scan_cell_common::ConnectionError {
 public:
  using ConnectionError::ConnectionError;
};

/// The connection to the trigger circuit: eight output lines.
class TriggerPort {
 public:
  virtual ~TriggerPort() = default;

  /// Sets all lines at once.
  /// @throw scan_cell_common::ConnectionError if the circuit cannot be reached
  virtual void write(std::uint8_t data) = 0;
};

/// Which port to use. Plain data, since it is sent to the guardian process as bytes.
struct PortAddress {
  /// A PC's port, or the simulator.
  enum class Kind : std::uint8_t { kParallel, kLoopback };
  Kind kind = Kind::kLoopback;        //!< of the port
  char device[64] = "/dev/parport0";  //!< of a parallel port
  char host[64] = "127.0.0.1";        //!< of a loopback port: IPv4 address
  std::uint16_t port = 5420;          //!< of a loopback port

  /// @throw scan_cell_common::InvalidParameter if a text does not fit
  static PortAddress parallel(const std::string& device);
  /// @param host IPv4 address
  static PortAddress loopback(const std::string& host, std::uint16_t port);

  std::string name() const;  //!< such as /dev/parport0
};

/// Adds each parameter with its range and meaning.
void describe(scan_cell_common::ParameterTable& table, PortAddress& address);

/// @throw NoDevice, NoPermission, DeviceBusy, scan_cell_common::InvalidParameter
std::unique_ptr<TriggerPort> open_port(const PortAddress& address);

}  // namespace laser_trigger
