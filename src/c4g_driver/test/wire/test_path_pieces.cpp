// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <random>

#include "scan_cell_common/errors/errors.h"
#include "wire/path_pieces.h"
#include "wire/seal.h"
#include "wire/wire_units.h"

using c4g_driver::PathPiece;
using c4g_driver::pieces_of;
using c4g_driver::ToolMotion;
using scan_cell_common::UnusableInput;

namespace {

ToolMotion random_path(std::size_t size) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-1, 1);
  ToolMotion motion;
  for (std::size_t i = 0; i < size; ++i) {
    c4g_driver::ToolWaypoint waypoint;
    waypoint.tip.translation() << any(random), any(random), any(random);
    waypoint.tip.rotate(Eigen::AngleAxisd(
        3 * any(random), Eigen::Vector3d(any(random), any(random), any(random)).normalized()));
    waypoint.speed = 0.7 + 0.6 * any(random);
    waypoint.zone = 0.05 + 0.04 * any(random);
    waypoint.outputs = random();
    motion.waypoints.push_back(waypoint);
  }
  return motion;
}

}  // namespace

TEST(PathPieces, HoldEveryWaypointOnceInOrderToTheLastDigit) {
  const ToolMotion motion = random_path(1000);
  std::size_t next = 0;
  for (const PathPiece& piece : pieces_of(motion, 9)) {
    const std::string datagram = c4g_driver::build(piece, UINT64_MAX, UINT64_MAX);
    EXPECT_LE(datagram.size(), c4g_driver::kMaxDatagramBytes);
    const auto packet = nlohmann::json::parse(datagram);
    EXPECT_EQ(packet["path"], 9);
    EXPECT_EQ(packet["first"], next);
    for (const auto& numbers : packet["waypoints"]) {
      const auto& waypoint = motion.waypoints.at(next++);
      const c4g_driver::WireSix pose = c4g_driver::to_wire(waypoint.tip);
      for (std::size_t i = 0; i < 6; ++i)
        EXPECT_EQ(numbers[i].get<double>(), pose[i]);
      EXPECT_EQ(numbers[6].get<double>(), waypoint.speed / 1e-3);
      EXPECT_EQ(numbers[7].get<double>(), waypoint.zone / 1e-3);
      EXPECT_EQ(numbers[8].get<std::uint32_t>(), waypoint.outputs);
    }
  }
  EXPECT_EQ(next, motion.waypoints.size());
}

TEST(PathPieces, AreFewerThanTheWaypoints) {
  EXPECT_LT(pieces_of(random_path(1000), 1).size(), 150u);
}

TEST(PathPieces, NameTheWaypointThatTheProtocolHasNoPlaceFor) {
  EXPECT_THROW(pieces_of({}, 1), UnusableInput);
  EXPECT_THROW(pieces_of(random_path(1), 1), UnusableInput);
  EXPECT_THROW(pieces_of(random_path(10001), 1), UnusableInput);
  const auto complaint = [](auto change) {
    ToolMotion motion = random_path(5);
    change(motion.waypoints[3]);
    try {
      pieces_of(motion, 1);
    } catch (const UnusableInput& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  for (const double bad : {0.0, -1.0, 1.51, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_NE(complaint([&](auto& w) { w.speed = bad; }).find("waypoint 3, speed"),
              std::string::npos);
  for (const double bad : {-1e-9, 0.101, std::numeric_limits<double>::infinity()})
    EXPECT_NE(complaint([&](auto& w) { w.zone = bad; }).find("waypoint 3, zone"),
              std::string::npos);
}

TEST(PathChecksum, IsTheCrc32OfTheSealsWithACommaEach) {
  c4g_driver::PathChecksum sum;
  // zlib.crc32(b"12345,6789,") of Python
  sum.add("{\"a\":1,\"crc\":12345}");
  sum.add("{\"b\":2,\"crc\":6789}");
  EXPECT_EQ(sum.value(), 668090706u);
  EXPECT_EQ(sum.confirmation(7), "[7,668090706]");
}
