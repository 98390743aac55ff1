// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "laser_trigger/trigger_port.h"

#include <cstring>

#include "loopback_port.h"
#include "parallel_port.h"

namespace laser_trigger {
namespace {

template <std::size_t N>
void copy(char (&to)[N], const std::string& from, const char* name) {
  if (from.empty() || from.size() >= N) {
    throw scan_cell_common::InvalidParameter(name, "'" + from + "'",
                                             "give 1 to " + std::to_string(N - 1) + " characters");
  }
  std::memcpy(to, from.c_str(), from.size() + 1);
}

}  // namespace

PortAddress PortAddress::parallel(const std::string& device) {
  PortAddress address;
  address.kind = Kind::Parallel;
  copy(address.device, device, "device");
  return address;
}

PortAddress PortAddress::loopback(const std::string& host, std::uint16_t port) {
  PortAddress address;
  address.kind = Kind::Loopback;
  copy(address.host, host, "loopback_host");
  address.port = port;
  return address;
}

std::string PortAddress::name() const {
  return kind == Kind::Parallel ? device : std::string(host) + ":" + std::to_string(port);
}

std::unique_ptr<TriggerPort> open_port(const PortAddress& address) {
  if (address.kind == PortAddress::Kind::Parallel) {
    return std::make_unique<ParallelPort>(address.device);
  }
  return std::make_unique<LoopbackPort>(address.host, address.port);
}

}  // namespace laser_trigger
