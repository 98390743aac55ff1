// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "laser_trigger/trigger_port.h"

#include <fmt/format.h>

#include <cstring>

#include "loopback_port.h"
#include "parallel_port.h"
#include "scan_cell_common/parameters/parameter_table.h"

namespace laser_trigger {
namespace {

template <std::size_t N>
void copy(char (&to)[N], const std::string& from, const char* name) {
  if (from.empty() || from.size() >= N) {
    throw scan_cell_common::InvalidParameter(name, "'" + from + "'",
                                             fmt::format("give 1 to {} characters", N - 1));
  }
  std::memcpy(to, from.c_str(), from.size() + 1);
}

}  // namespace

void describe(scan_cell_common::ParameterTable& table, PortAddress& address) {
  PortAddress::Kind kind = address.kind;
  std::string device = address.device;
  std::string host = address.host;
  std::uint16_t port = address.port;
  table.choice("port", kind, {"parallel", "loopback"},
               "parallel: a PC's parallel port; loopback: the simulator");
  table.add("device", device, "device, for `port: parallel`");
  table.add("loopback_host", host, "IPv4 address, for `port: loopback`");
  table.add("loopback_port", port, {1, 65535}, "UDP port, for `port: loopback`");
  address = kind == PortAddress::Kind::kParallel ? PortAddress::parallel(device)
                                                 : PortAddress::loopback(host, port);
}

PortAddress PortAddress::parallel(const std::string& device) {
  PortAddress address;
  address.kind = Kind::kParallel;
  copy(address.device, device, "device");
  return address;
}

PortAddress PortAddress::loopback(const std::string& host, std::uint16_t port) {
  PortAddress address;
  address.kind = Kind::kLoopback;
  copy(address.host, host, "loopback_host");
  address.port = port;
  return address;
}

std::string PortAddress::name() const {
  return kind == Kind::kParallel ? device : fmt::format("{}:{}", std::string(host), port);
}

std::unique_ptr<TriggerPort> open_port(const PortAddress& address) {
  if (address.kind == PortAddress::Kind::kParallel) {
    return std::make_unique<ParallelPort>(address.device);
  }
  return std::make_unique<LoopbackPort>(address.host, address.port);
}

}  // namespace laser_trigger
