// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/asio.hpp>
#include <cstdint>
#include <string>

namespace scan_cell_demo {

/// A client of videe_node on this machine (docs/videe_protocol.md).
class VideeClient {
 public:
  /// @throw scan_cell_common::ConnectionError if no ViDeE server answers there
  explicit VideeClient(std::uint16_t port);

  /// @return the text after OK
  /// @throw scan_cell_common::Refused with the reason after ERROR
  /// @throw scan_cell_common::ConnectionError if no answer comes
  std::string ask(const std::string& command);

 private:
  boost::asio::ip::tcp::iostream connection_;
};

}  // namespace scan_cell_demo
