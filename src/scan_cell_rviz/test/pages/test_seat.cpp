// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
// The seat with a fake recipes node: a person's clicks, and what the seat then shows.
#include <actionlib_msgs/GoalID.h>
#include <gtest/gtest.h>
#include <scan_cell_msgs/RobotStatus.h>
#include <scan_cell_msgs/TriggerState.h>

#include <QApplication>
#include <QFile>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>
#include <csignal>
#include <functional>

#include "fixtures/a_seat.h"
#include "scan_cell_common/testing/child_process.h"

namespace scan_cell_rviz {
namespace {

using scan_cell_msgs::RobotStatus;
using scan_cell_msgs::RunSummary;

constexpr const char* kRobot = R"(<robot name="arm"><link name="a"/><link name="b"/>
  <joint name="J2" type="revolute"><parent link="a"/><child link="b"/><axis xyz="0 0 1"/>
    <limit lower="-2" upper="2" velocity="1" effort="1"/></joint></robot>)";
constexpr const char* kPlayRecipes = "--play-recipes";

TEST_F(ASeat, ScansTheChosenPartAndShowsVerdictAndFigures) {
  EXPECT_FALSE(button("run")->isEnabled()) << "no part was chosen";
  choose_frame();
  find<QLineEdit>("run_note")->setText("serial 7");
  scan();
  EXPECT_EQ(recipes_->last_goal().recipe, "frame");
  EXPECT_EQ(recipes_->last_goal().note, "serial 7");
  EXPECT_TRUE(comes([this] { return text("doing") == "scan"; }));
  EXPECT_FALSE(button("run")->isEnabled()) << "one scan at a time";
  EXPECT_FALSE(button("jog_plus_1")->isEnabled()) << "the scan moves the robot";
  recipes_->finish(RunSummary::ACCEPTED);
  ASSERT_TRUE(comes([this] { return text("verdict").find("Accepted") != std::string::npos; }));
  EXPECT_EQ(find<QTabWidget>("pages")->currentIndex(), 2);
  auto* const figures = find<QTableWidget>("figures");
  ASSERT_EQ(figures->rowCount(), 2);
  EXPECT_EQ(figures->item(1, 1)->text(), "0.0213 mm");
  EXPECT_EQ(figures->item(0, 2)->text(), "0.45 to 2.2") << "what it is judged by";
  EXPECT_EQ(figures->item(1, 2)->text(), "");
  EXPECT_TRUE(comes([this] { return button("run")->isEnabled(); }));
  EXPECT_TRUE(button("jog_plus_1")->isEnabled());
}

TEST_F(ASeat, TellsOfAScanThatAnyProgramBeganAndStopsIt) {
  ros::NodeHandle node;
  ros::Publisher status =
      node.advertise<actionlib_msgs::GoalStatusArray>("/scan_cell/scan/status", 1, true);
  const ros::Publisher cell = node.advertise<scan_cell_msgs::CellState>("/scan_cell/state", 1);
  bool cancelled = false;
  const ros::Subscriber cancel = node.subscribe<actionlib_msgs::GoalID>(
      "/scan_cell/scan/cancel", 1, [&](const auto&) { cancelled = true; });
  actionlib_msgs::GoalStatusArray goals;
  goals.status_list.resize(1);
  goals.status_list[0].status = actionlib_msgs::GoalStatus::ACTIVE;
  status.publish(goals);
  choose_frame();
  ASSERT_TRUE(comes([this] { return button("stop")->isEnabled(); }));
  EXPECT_FALSE(button("run")->isEnabled()) << "the robot moves";
  ASSERT_TRUE(comes([&] { return cancel.getNumPublishers() > 0; }));
  click("stop");
  EXPECT_TRUE(comes([&] { return cancelled; }));
  status.publish(actionlib_msgs::GoalStatusArray());
  EXPECT_TRUE(comes([this] { return text("doing") == "Nothing is under way."; })) << text("doing");
  EXPECT_TRUE(button("run")->isEnabled());
}

TEST_F(ASeat, StopsTheCellItselfWhereItGoesOnAfterStop) {
  ros::NodeHandle node;
  const ros::Publisher cell = node.advertise<scan_cell_msgs::CellState>("/scan_cell/state", 1);
  ros::Publisher status =
      node.advertise<actionlib_msgs::GoalStatusArray>("/scan_cell/scan/status", 1);
  bool cancelled = false;
  const ros::Subscriber cancel = node.subscribe<actionlib_msgs::GoalID>(
      "/scan_cell/scan/cancel", 1, [&](const auto&) { cancelled = true; });
  ASSERT_TRUE(comes([&] { return cancel.getNumPublishers() > 0; }));
  scan();
  actionlib_msgs::GoalStatusArray goals;
  goals.status_list.resize(1);
  goals.status_list[0].status = actionlib_msgs::GoalStatus::ACTIVE;
  click("stop");
  EXPECT_TRUE(comes([&] {
    status.publish(goals);  // as an action server does, several times a second
    QTest::qWait(50);
    return cancelled;
  }));
}

TEST_F(ASeat, ChangesNoValueForWhoScrollsOverAPage) {
  find<QTabWidget>("pages")->setCurrentIndex(1);
  auto* const depth = find<QDoubleSpinBox>("edit_depth");
  const double before = depth->value();
  const auto turn = [&] {
    QWheelEvent event(QPointF(2, 2), depth->mapToGlobal(QPoint(2, 2)), {}, QPoint(0, 120),
                      Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(depth, &event);
  };
  turn();
  EXPECT_EQ(depth->value(), before);
  QApplication::setActiveWindow(&seat_);
  depth->setFocus();
  ASSERT_TRUE(comes([&] { return depth->hasFocus(); }));
  turn();
  EXPECT_GT(depth->value(), before) << "this one was chosen";
}

TEST_F(ASeat, SaysWhatMakesTheFirstRecipeWhereThereIsNone) {
  QFile file(README);
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  const QString readme = QString::fromUtf8(file.readAll()).replace('\\', ' ').simplified();
  const auto gives_command = [&](const QString& folder) {
    const QString said = find<QLabel>("missed")->text();
    const QString command = said.section("\n\n", 1), where = " --recipes " + folder;
    return command.startsWith("rosrun part_recipes recipe new ") && command.endsWith(where) &&
           readme.contains(command.chopped(where.size()));
  };
  ros::param::set("/part_recipes/recipes", "/the parts' recipes");
  EXPECT_FALSE(find<QLabel>("missed")->isVisible()) << "there are recipes";
  recipes_->take_recipes_away();
  click("refresh");
  EXPECT_TRUE(comes([&] {
    return recipe_list()->count() == 0 && gives_command(R"('/the parts'\'' recipes')");
  })) << text("missed");
  EXPECT_TRUE(find<QLabel>("missed")->isVisible());
  EXPECT_EQ(text("missed").find("There is no recipe in /the parts' recipes yet"), 0u)
      << text("missed");
  recipes_.reset();
  EXPECT_TRUE(comes([&] { return text("missed").find("is not running") != std::string::npos; }))
      << text("missed");
  EXPECT_TRUE(gives_command("FOLDER")) << text("missed");
  ros::param::del("/part_recipes/recipes");
}

TEST_F(ASeat, RefusesAPartTypeThatIsOutOfDateAndSaysWhy) {
  recipe_list()->setCurrentRow(1);
  EXPECT_FALSE(button("run")->isEnabled());
  const std::string shown = recipe_list()->item(1)->text().toStdString();
  EXPECT_NE(shown.find("changed since the recipe was proven"), std::string::npos) << shown;
}

TEST_F(ASeat, StopsTheScanAndSaysThatThereIsNoRun) {
  scan();
  ASSERT_TRUE(comes([this] { return button("stop")->isEnabled(); }));
  click("stop");
  ASSERT_TRUE(comes([this] { return trouble() == "stopped by the person"; })) << trouble();
  EXPECT_TRUE(recipes_->was_cancelled());
  EXPECT_TRUE(comes([this] { return button("run")->isEnabled(); }));
}

TEST_F(ASeat, LetsNobodyApproveOrWorkARefusedPart) {
  seat_.set_person("Ada");
  scan_to(RunSummary::REFUSED);
  EXPECT_NE(text("verdict").find("wrong_part"), std::string::npos) << text("verdict");
  EXPECT_EQ(text("message"), "one region differs");
  auto* const waypoints = find<QListWidget>("waypoints");
  ASSERT_EQ(waypoints->count(), 2);
  EXPECT_EQ(waypoints->item(1)->text(), "waypoint 17 at 10.0, -20.5, 3.0 mm");
  QSignalSpy chosen(&seat_, &Seat::placeChosen);
  waypoints->setCurrentRow(1);
  ASSERT_EQ(chosen.count(), 1) << "the view does not turn there";
  EXPECT_EQ(chosen.at(0).at(1).toDouble(), -0.0205);
  EXPECT_FALSE(button("approve")->isEnabled());
  click("refuse");
  EXPECT_TRUE(comes([this] { return text("decision") == "Refused by Ada"; }));
  EXPECT_FALSE(button("dry_run")->isEnabled());
}

TEST_F(ASeat, WatchesWhileAnotherSeatHasTheCell) {
  scan();
  OpenSeat other;
  const Seat& watching = other.seat_;
  other.links_.start();
  auto* const doing = watching.findChild<QLabel*>("doing");
  ASSERT_TRUE(comes([&] { return doing->text().startsWith("Another seat"); }));
  watching.findChild<QListWidget*>("recipes")->setCurrentRow(0);
  EXPECT_FALSE(watching.findChild<QPushButton*>("run")->isEnabled());
  QTest::mouseClick(watching.findChild<QPushButton*>("stop"), Qt::LeftButton);
  EXPECT_TRUE(comes([this] { return recipes_->was_cancelled(); })) << "anybody may stop the robot";
  EXPECT_TRUE(comes([&] { return other.link_.busy() == Busy::kFree; }));
}

TEST_F(ASeat, GoesOnWhereTheNodeIsKilledAmidAScanAndComesBack) {
  recipes_.reset();
  {
    scan_cell_common::ChildProcess node({TEST_PROGRAM, kPlayRecipes}, true);
    choose_frame();
    ASSERT_TRUE(comes([this] {
      if (link_.busy() == Busy::kFree) click("run");
      QTest::qWait(100);
      return text("doing") == "scan";
    })) << trouble();
    kill(node.id(), SIGKILL);
    node.wait();
  }
  ASSERT_TRUE(comes([this] { return trouble().find("is gone") != std::string::npos; }))
      << trouble();
  click("refresh");
  EXPECT_TRUE(comes([this] { return text("missed").find("no such service") != std::string::npos; }))
      << text("missed");
  recipes_ = std::make_unique<FakeRecipes>();
  scan_to(RunSummary::ACCEPTED);
  EXPECT_NE(text("verdict").find("Accepted"), std::string::npos);
}

TEST_F(ASeat, IsNotHeldUpByAServiceThatHangs) {
  std::promise<void> answer;
  recipes_->hold_list(answer.get_future().share());
  click("refresh");
  find<QTabWidget>("pages")->setCurrentIndex(0);
  choose_frame();
  EXPECT_TRUE(button("run")->isEnabled()) << "the window answers";
  scan();
  EXPECT_EQ(recipes_->goals(), 1) << "a scan begins while the list is waited for";
  answer.set_value();
  recipes_->finish(RunSummary::ACCEPTED);
  EXPECT_TRUE(comes([this] { return link_.busy() == Busy::kFree; }));
}

TEST_F(ASeat, ShowsADeviceThatFailsALaserThatIsOnAndANodeThatIsGone) {
  EXPECT_TRUE(
      comes([this] { return text("sign_robot").find("not running") != std::string::npos; }));
  ros::NodeHandle node;
  ros::Publisher robot = node.advertise<RobotStatus>("/c4g_driver/status", 1, true);
  ros::Publisher trigger =
      node.advertise<scan_cell_msgs::TriggerState>("/laser_trigger/state", 1, true);
  RobotStatus status;
  status.connected = 1;
  status.e_stopped = RobotStatus::YES;
  robot.publish(status);
  scan_cell_msgs::TriggerState lasers;
  lasers.lasers = 2;
  trigger.publish(lasers);
  EXPECT_TRUE(
      comes([this] { return text("sign_robot").find("emergency stop") != std::string::npos; }));
  EXPECT_TRUE(comes([this] { return text("sign_laser").find("ON: 1") != std::string::npos; }));
  robot.shutdown();
  EXPECT_TRUE(
      comes([this] { return text("sign_robot").find("not running") != std::string::npos; }));
}

TEST_F(ASeat, OpensAnEarlierRunFromTheHistory) {
  auto* const pages = find<QTabWidget>("pages");
  pages->setCurrentIndex(5);
  auto* const runs = find<QTableWidget>("runs");
  ASSERT_TRUE(comes([&] { return runs->rowCount() == 1; })) << trouble();
  EXPECT_EQ(runs->item(0, 0)->text(), "2026-11-25T12:13:14");
  Q_EMIT runs->cellActivated(0, 0);
  EXPECT_TRUE(comes([this] { return !text("verdict").empty(); }));
  EXPECT_EQ(pages->currentIndex(), 2);
}

}  // namespace
}  // namespace scan_cell_rviz

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  qputenv("QT_QPA_PLATFORM", "offscreen");
  const bool plays = argc > 1 && std::string(argv[1]) == "--play-recipes";
  ros::init(argc, argv, plays ? "part_recipes" : "test_seat");
  if (plays) {
    const scan_cell_rviz::FakeRecipes recipes;
    ros::spin();
    return 0;
  }
  ros::AsyncSpinner spinner(4);
  spinner.start();
  ros::param::set("robot_description", scan_cell_rviz::kRobot);
  ros::param::set("/c4g_driver/joint_lower", std::vector<double>{-9, -1});
  const QApplication application(argc, argv);
  return RUN_ALL_TESTS();
}
