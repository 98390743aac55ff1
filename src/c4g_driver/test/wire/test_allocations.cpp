// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <vector>

#include "link/client_test.h"
#include "wire/allocations.h"
#include "wire/codec.h"
#include "wire/seal.h"

using namespace c4g_driver;  // NOLINT
using nlohmann::json;

namespace {

const json kComplaint = {{"code", 15}, {"text", std::string(80, 'x')}};

}  // namespace

TEST(Allocations, AreCounted) {
  if (!counts_allocations()) GTEST_SKIP() << "a sanitizer has the heap";
  const std::uint64_t before = allocations_of_this_thread();
  auto some = std::make_unique<std::vector<int>>(100);
  some->resize(1000);
  EXPECT_EQ(allocations_of_this_thread(), before + 3);
}

TEST_F(ClientTest, AllocatesNothingBetweenDatagramAndHandingOn) {
  if (!counts_allocations()) GTEST_SKIP() << "a sanitizer has the heap";
  constexpr std::size_t kEnough = 300;
  std::mutex mutex;
  std::vector<std::uint64_t> counts;
  counts.reserve(100'000);
  const auto heard = [&] {
    const std::lock_guard<std::mutex> lock(mutex);
    return counts.size();
  };
  client_ = std::make_unique<Client>(options(controller_->port()), [&](const MeasuredState&) {
    const std::lock_guard<std::mutex> lock(mutex);
    if (counts.size() < counts.capacity()) counts.push_back(allocations_of_this_thread());
  });
  EXPECT_TRUE(eventually([this] { return client_->link().up; }));
  // moving: polled and streamed at once, with everything that a state can hold
  controller_->set_state(
      {{"status", "moving"},
       {"motion", 1},
       {"error", kComplaint},
       {"alarms", json::array({kComplaint, kComplaint, kComplaint, kComplaint})}});
  EXPECT_TRUE(eventually([&] { return heard() >= kEnough; }, 60));
  client_.reset();
  EXPECT_EQ(counts.back(), counts.front()) << "over " << counts.size() << " poses";
}

TEST(Parse, AllocatesNothingForADatagramHoweverItsValuesLie) {
  if (!counts_allocations()) GTEST_SKIP() << "a sanitizer has the heap";
  const json good = {{"c4g", 1},
                     {"session", 1},
                     {"type", "state"},
                     {"n", 1},
                     {"t", 1},
                     {"pose", {800, 0, 600, 0, 180, 180}},
                     {"joints", {0, 8.1589, -124.1102, 0, 47.7310, 0}},
                     {"status", "moving"},
                     {"motion", 1},
                     {"progress", 0.5},
                     {"camera_fps", 0},
                     {"e_stop", false},
                     {"drives", true},
                     {"mode", "remote"},
                     {"override", 100},
                     {"linear_speed", 250},
                     {"waypoint", 0},
                     {"outputs", 0},
                     {"error", nullptr},
                     {"alarms", json::array()}};
  const std::string text = good.dump();
  const std::size_t room = (kMaxDatagramBytes - text.size() - 60) / 2;
  std::string flat = "[0";
  for (std::size_t i = 1; i < room; ++i)
    flat += ",0";
  for (const std::string& more :
       {std::string("0"), flat + "]", std::string(room, '[') + std::string(room, ']')}) {
    const std::string datagram = seal(text.substr(0, text.size() - 1) + ",\"more\":" + more + "}");
    ASSERT_LE(datagram.size(), kMaxDatagramBytes);
    const std::uint64_t before = allocations_of_this_thread();
    const Reply reply = parse(datagram);
    EXPECT_EQ(allocations_of_this_thread(), before) << more;
    EXPECT_TRUE(std::holds_alternative<StreamedState>(reply));
  }
}
