// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/net/endpoint.h"

#include <arpa/inet.h>
#include <fmt/core.h>

#include "scan_cell_common/errors/errors.h"

namespace scan_cell_common {

Endpoint Endpoint::parse(const std::string& name, const std::string& address, std::uint16_t port) {
  in_addr parsed{};
  if (inet_pton(AF_INET, address.c_str(), &parsed) != 1) {
    throw InvalidParameter(name, "'" + address + "'", "give an IPv4 address such as 127.0.0.1");
  }
  return {ntohl(parsed.s_addr), port};
}

sockaddr_in Endpoint::to_kernel() const {
  sockaddr_in result{};
  result.sin_family = AF_INET;
  result.sin_port = htons(port);
  result.sin_addr.s_addr = htonl(address);
  return result;
}

Endpoint Endpoint::from_kernel(const sockaddr_in& address) {
  return {ntohl(address.sin_addr.s_addr), ntohs(address.sin_port)};
}

std::string Endpoint::text() const {
  return fmt::format("{}.{}.{}.{}:{}", address >> 24, address >> 16 & 255, address >> 8 & 255,
                     address & 255, port);
}

}  // namespace scan_cell_common
