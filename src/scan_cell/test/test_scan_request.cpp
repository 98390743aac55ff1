// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <limits>

#include "scan_cell/scan_request.h"
#include "scan_cell_common/errors/errors.h"

using scan_cell::ScanRequest;

namespace {

ScanRequest good() {
  ScanRequest request;
  request.start.translation() << 0.6, 0, 0.6;
  request.end.translation() << 0.9, 0, 0.6;
  request.speed = 0.1;
  request.rate = 100;
  request.lasers = 1;
  return request;
}

/// What check() names as wrong after `change`.
template <class Change>
std::string refused(const Change& change) {
  ScanRequest request = good();
  change(request);
  try {
    check(request, {});
  } catch (const scan_cell_common::Refused& error) {
    return error.thing();
  }
  return "nothing";
}

}  // namespace

TEST(ScanRequest, IsAcceptedWithinTheLimits) {
  EXPECT_EQ(refused([](ScanRequest&) {}), "nothing");
}

TEST(ScanRequest, IsRefusedByNameOutsideTheLimits) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refused([](ScanRequest& r) { r.speed = 0; }), "speed");
  EXPECT_EQ(refused([](ScanRequest& r) { r.speed = -0.1; }), "speed");
  EXPECT_EQ(refused([&](ScanRequest& r) { r.speed = nan; }), "speed");
  EXPECT_EQ(refused([](ScanRequest& r) { r.rate = 501; }), "frame rate");
  EXPECT_EQ(refused([](ScanRequest& r) { r.rate = 1.9; }), "frame rate");
  EXPECT_EQ(refused([](ScanRequest& r) { r.end = r.start; }), "length of the scan");
  EXPECT_EQ(refused([](ScanRequest& r) { r.end.translation().x() = 5; }), "length of the scan");
  EXPECT_EQ(refused([&](ScanRequest& r) { r.start.translation().x() = nan; }), "start of the scan");
  EXPECT_EQ(refused([](ScanRequest& r) { r.lasers = 0; }), "lasers");
  EXPECT_EQ(refused([](ScanRequest& r) { r.lasers = 3; }), "lasers");
}
