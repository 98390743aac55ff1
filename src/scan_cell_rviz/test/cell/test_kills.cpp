// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
// Nodes of the simulated cell are killed under an open seat, on each of its pages.
#include <gtest/gtest.h>

#include <QApplication>
#include <QTest>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <random>

#include "fixtures/hold_ups.h"
#include "fixtures/open_seat.h"
#include "scan_cell_common/ros/node_process.h"

namespace scan_cell_rviz {
namespace {

using scan_cell_common::process_of;

constexpr int kPatience = 60000;  // [ms] roslaunch restarts a node after some seconds
constexpr unsigned kSeed = 20261126;
constexpr double kMostHeldUp = 1000;  // [ms] bearable for a person, on a fully loaded machine

/// A node, the label that reports it, and the label's text when the node is gone.
struct Victim {
  const char* node;
  const char* label;
  const char* gone;
};
constexpr Victim kVictims[] = {{"/c4g_driver", "sign_robot", "not running"},
                               {"/laser_trigger", "sign_laser", "not running"},
                               {"/camera", "sign_camera", "reports nothing"},
                               {"/scan_cell", "sign_cell", "not running"},
                               {"/part_recipes", "missed", "not running"}};

class ASeatInTheCell : public testing::Test, protected OpenSeat {
 protected:
  ASeatInTheCell() {
    links_.start();
    seat_.show();
  }

  static bool comes(const std::function<bool()>& condition) {
    return QTest::qWaitFor(condition, kPatience);
  }

  bool is_gone(const Victim& victim) const {
    const auto* const label = seat_.findChild<QLabel*>(victim.label);
    return !label->isHidden() && label->text().contains(victim.gone);
  }
  bool all_are_there() const {
    return std::none_of(std::begin(kVictims), std::end(kVictims),
                        [this](const Victim& victim) { return is_gone(victim); });
  }

  void kill_one(const Victim& victim) {
    const auto process = process_of(victim.node);
    ASSERT_TRUE(process) << victim.node;
    ASSERT_EQ(kill(*process, SIGKILL), 0);
    ASSERT_TRUE(comes([&] { return is_gone(victim); }))
        << victim.node << ": " << text(victim.label);
    ASSERT_TRUE(comes([&] { return process_of(victim.node).value_or(*process) != *process; }))
        << victim.node << " was not started again";
    ASSERT_TRUE(comes([this] { return all_are_there(); }))
        << victim.node << ": " << text(victim.label);
  }

  HoldUps hold_ups_;
};

TEST_F(ASeatInTheCell, LivesWhicheverNodeIsKilledInWhicheverPageAndSaysSo) {
  const int kills = ros::param::param("~kills", 5);
  std::filesystem::create_directories(ros::param::param<std::string>("/part_recipes/recipes", ""));
  auto* const pages = seat_.findChild<QTabWidget*>("pages");
  ASSERT_TRUE(comes([this] { return all_are_there() && link_.busy() == Busy::kFree; }));
  std::mt19937 random(kSeed);
  for (int i = 0; i < kills; ++i) {
    const Victim& victim = kVictims[static_cast<std::size_t>(i) % std::size(kVictims)];
    const int page = static_cast<int>(random() % static_cast<unsigned>(pages->count()));
    pages->setCurrentIndex(page);
    hold_ups_.reset();
    kill_one(victim);
    if (HasFatalFailure()) return;
    EXPECT_LT(hold_ups_.longest(), kMostHeldUp) << victim.node << ", page " << page;
    std::printf("%d of %d: %s killed, page %d: the window was held up for %.0f ms at most\n", i + 1,
                kills, victim.node, page + 1, hold_ups_.longest());
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace scan_cell_rviz

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  qputenv("QT_QPA_PLATFORM", "offscreen");
  ros::init(argc, argv, "test_kills");
  const QApplication application(argc, argv);
  return RUN_ALL_TESTS();
}
