// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "wire/wire_units.h"

#include <cmath>

#include "scan_cell_common/pose/units.h"

namespace c4g_driver {
namespace {

using scan_cell_common::kDegree;

}  // namespace

WireSix to_wire(const Joints& joints) {
  WireSix wire{};
  Eigen::Map<Joints>(wire.data()) = joints / kDegree;
  return wire;
}

Joints joints_from_wire(const WireSix& wire) {
  return Eigen::Map<const Joints>(wire.data()) * kDegree;
}

}  // namespace c4g_driver
