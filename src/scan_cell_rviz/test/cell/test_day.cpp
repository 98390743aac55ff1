// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
// A day at the seat with a fake recipes node: run after run is scanned, cleaned, approved and
// worked.
#include <gtest/gtest.h>
#include <unistd.h>

#include <QApplication>
#include <QTest>
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <functional>
#include <vector>

#include "fixtures/a_seat.h"

#ifdef __SANITIZE_ADDRESS__
extern "C" std::size_t __sanitizer_get_current_allocated_bytes();  // GCC comes without its header
#endif

namespace scan_cell_rviz {
namespace {

using scan_cell_msgs::RunSummary;

constexpr int kSide = 50;  // of each scan: 125,000 points
constexpr double kMegabyte = 1e6;
constexpr double kMostGrowth =
    25;  // [MB] from the first third to the last; a scan and its edits take 4

/// [MB] used by this process. AddressSanitizer keeps freed memory back: there only what is in use
/// counts.
double used() {
#ifdef __SANITIZE_ADDRESS__
  return static_cast<double>(__sanitizer_get_current_allocated_bytes()) / kMegabyte;
#else
  std::ifstream statm("/proc/self/statm");
  double all = 0, held = 0;
  statm >> all >> held;
  return held * static_cast<double>(sysconf(_SC_PAGESIZE)) / kMegabyte;
#endif
}

class ADay : public ASeat {
 protected:
  ADay() {
    recipes_->give_each_run_a_scan(kSide);
    choose_frame();
  }

  void press(const char* name) const {
    ASSERT_TRUE(comes([&] { return button(name)->isEnabled(); })) << name << ": " << trouble();
    button(name)->click();
  }

  /// Repeats until the goal has come: the server may not be connected yet.
  void begin(const char* name) {
    const int before = recipes_->goals();
    ASSERT_TRUE(comes([&] {
      if (link_.busy() == Busy::kFree && button(name)->isEnabled()) button(name)->click();
      QTest::qWait(20);
      return recipes_->goals() > before;
    })) << name
        << ": " << text("trouble");
  }

  /// Waits for the scan of the described run.
  void wait_for_scan() {
    ASSERT_TRUE(comes([this] {
      const EditedViewPtr view = edits_.view();
      return view && view->source != scan_;
    })) << text("trouble");
    scan_ = edits_.view()->source;
  }

  void clean_by_hand() {
    cloud_preprocess::HalfSpace upper;
    upper.point.z() = 0.5e-3 * kSide;
    const std::size_t all = std::size_t{kSide} * kSide * kSide;
    edits_.add({false, upper});
    ASSERT_TRUE(comes([&] { return edits_.view()->kept.size() < all; }));
    edits_.undo();
    ASSERT_TRUE(comes([&] { return edits_.view()->kept.size() == all; }));
  }

  void run_one() {
    begin("run");
    recipes_->finish(RunSummary::ACCEPTED);
    ASSERT_TRUE(comes([this] { return link_.busy() == Busy::kFree; })) << text("trouble");
    wait_for_scan();
    clean_by_hand();
    press("approve");
    wait_for_scan();
    ASSERT_TRUE(comes([this] { return text("decision").find("Approved") == 0; }));
    begin("dry_run");
    recipes_->finish(RunSummary::ACCEPTED);
    ASSERT_TRUE(comes([this] { return link_.busy() == Busy::kFree; })) << text("trouble");
    wait_for_scan();
  }

  std::shared_ptr<const cloud_preprocess::Cloud> scan_;  // the latest one
};

TEST_F(ADay, DoesNotFillTheMemory) {
  const int runs = ros::param::param("~runs", 60);
  seat_.set_person("Ada");
  std::vector<double> held;
  for (int run = 1; run <= runs; ++run) {
    run_one();
    ASSERT_FALSE(HasFatalFailure()) << "run " << run;
    held.push_back(used());
    if (run % 10 == 0) std::printf("%d of %d runs: %.1f MB\n", run, runs, held.back());
    std::fflush(stdout);
  }
  const auto third = static_cast<std::ptrdiff_t>(held.size() / 3);
  const double first = *std::max_element(held.begin(), held.begin() + third);
  const double last = *std::max_element(held.end() - third, held.end());
  EXPECT_LT(last, first + kMostGrowth);
}

}  // namespace
}  // namespace scan_cell_rviz

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  qputenv("QT_QPA_PLATFORM", "offscreen");
  ros::init(argc, argv, "test_day");
  const QApplication application(argc, argv);
  ros::AsyncSpinner spinner(2);  // for the fake node
  spinner.start();
  return RUN_ALL_TESTS();
}
