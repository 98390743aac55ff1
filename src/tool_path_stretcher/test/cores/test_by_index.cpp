// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <mutex>
#include <numeric>
#include <set>
#include <stdexcept>
#include <thread>

#include "cores/by_index.h"
#include "report.h"
#include "stretch_case.h"

using namespace tool_path_stretcher;

namespace {

/// Calls work with that many threads available, whatever the machine has.
template <class Work>
void with_threads(std::size_t count, const Work& work) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, count);
  tbb::task_arena(static_cast<int>(count)).execute(work);
}

/// The whole result as text, without the time it took.
std::string bytes_of(StretchResult result) {
  result.seconds = 0;
  std::string text = report_to_json(result);
  const auto add = [&text](const Eigen::Isometry3d& pose) {
    text.append(reinterpret_cast<const char*>(pose.data()), sizeof(double) * 16);
  };
  for (const Segment& segment : result.path.segments) {
    for (const Waypoint& waypoint : segment.waypoints)
      add(waypoint.pose);
  }
  return text;
}

Case bent_case() {
  Case each;
  each.part = each.scanned_part = synthetic::curved_panel();
  each.path = synthetic::path_on(each.part, kWaypoints);
  each.deformation = synthetic::bend(0.004, 0.3);
  return each;
}

}  // namespace

TEST(ByIndex, DoesEachIndexOnceOnAnyNumberOfThreads) {
  constexpr std::size_t kCount = 10007;
  for (const std::size_t threads : {1, 2, 7}) {
    std::vector<std::atomic<int>> done(kCount);
    with_threads(threads, [&] { for_indices(kCount, 3, [&](std::size_t i) { ++done[i]; }); });
    for (const std::atomic<int>& each : done)
      ASSERT_EQ(each, 1);
  }
}

TEST(ByIndex, KeepsTheOrderOfResults) {
  with_threads(4, [] {
    const auto odd = all_of<std::size_t>(1000, kSingly, [](std::size_t i) {
      return i % 2 == 1 ? std::optional<std::size_t>(i) : std::nullopt;
    });
    ASSERT_EQ(odd.size(), 500U);
    for (std::size_t k = 0; k < odd.size(); ++k)
      EXPECT_EQ(odd[k], 2 * k + 1);
  });
}

TEST(ByIndex, WorkWithinWorkTakesNoMoreThreads) {
  constexpr std::size_t kThreads = 3;
  std::mutex mutex;
  std::set<std::thread::id> threads;
  with_threads(kThreads, [&] {
    for_indices(20, kSingly, [&](std::size_t) {
      for_indices(20, kSingly, [&](std::size_t) {
        const std::lock_guard<std::mutex> lock(mutex);
        threads.insert(std::this_thread::get_id());
      });
    });
  });
  EXPECT_LE(threads.size(), kThreads);
}

TEST(ByIndex, LetsWhatWorkThrowsThrough) {
  with_threads(4, [] {
    EXPECT_THROW(for_indices(1000, kSingly,
                             [](std::size_t i) {
                               if (i == 500) throw std::out_of_range("500");
                             }),
                 std::out_of_range);
  });
}

TEST(Stretcher, LeavesTheSameBytesOnAnyNumberOfThreads) {
  for (const Case& each : {Case(), bent_case()}) {
    std::string alone, together;
    with_threads(1, [&] { alone = bytes_of(each.run()); });
    with_threads(4, [&] { together = bytes_of(each.run()); });
    EXPECT_NE(alone.find("accepted"), std::string::npos);
    EXPECT_EQ(alone, together);
  }
}

TEST(Stretcher, ReportsProgressFromOneThreadAtATime) {
  with_threads(4, [] {
    std::atomic<int> inside{0};
    bent_case().run([&inside](const std::string&, double) {
      EXPECT_EQ(++inside, 1);
      std::this_thread::yield();
      --inside;
      return true;
    });
  });
}
