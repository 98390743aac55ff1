// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "scan_cell_common/net/endpoint.h"

namespace scan_cell_sim {

/// Data from a peer, or for one.
struct Datagram {
  scan_cell_common::Endpoint peer;
  std::string text;
};

}  // namespace scan_cell_sim
