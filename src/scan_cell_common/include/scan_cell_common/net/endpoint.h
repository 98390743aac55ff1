// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <netinet/in.h>

#include <cstdint>
#include <string>
#include <tuple>

namespace scan_cell_common {

/// An IPv4 address and a port, in the host's byte order: 127.0.0.1 is 0x7f000001.
struct Endpoint {
  std::uint32_t address = 0;  //!< IPv4
  std::uint16_t port = 0;     //!< UDP or TCP

  /// @param name of the address in errors
  /// @param address such as 127.0.0.1
  /// @throw InvalidParameter if it is not an IPv4 address
  static Endpoint parse(const std::string& name, const std::string& address, std::uint16_t port);

  /// In the form of the kernel's calls.
  sockaddr_in to_kernel() const;
  static Endpoint from_kernel(const sockaddr_in& address);  //!< from the form of the kernel's calls

  /// Such as 127.0.0.1:5410.
  std::string text() const;

  /// Whether they are the same endpoint.
  bool operator==(const Endpoint& other) const {
    return std::tie(address, port) == std::tie(other.address, other.port);
  }
  bool operator!=(const Endpoint& other) const {
    return !(*this == other);
  }  //!< whether they differ
  /// By address, then by port.
  bool operator<(const Endpoint& other) const {
    return std::tie(address, port) < std::tie(other.address, other.port);
  }
};

}  // namespace scan_cell_common
