// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
// The seat with a fake node of recipes: clicked as a person clicks, judged by what it then says.
#include <actionlib_msgs/GoalID.h>
#include <gtest/gtest.h>
#include <scan_cell_msgs/RobotStatus.h>
#include <scan_cell_msgs/TriggerState.h>

#include <QApplication>
#include <QFile>
#include <QMessageBox>
#include <QSignalSpy>
#include <QTest>
#include <QTimer>
#include <QWheelEvent>
#include <csignal>
#include <functional>

#include "fixtures/a_seat.h"
#include "fixtures/made_preview.h"
#include "pages/shift/work_page.h"
#include "scan_cell_common/files/yaml_file.h"
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

TEST_F(ASeat, AsksBeforeAPartIsWorkedAgain) {
  recipes_->set_works(2);
  scan_to(RunSummary::ACCEPTED);
  find<QLineEdit>("person")->setText("Ada");
  click("approve");
  ASSERT_TRUE(comes([this] { return button("work")->isEnabled(); }));
  EXPECT_NE(text("work_part").find("Worked: 2."), std::string::npos) << text("work_part");
  const int before = recipes_->goals();
  bool asked = false;
  QTimer::singleShot(0, [&] {
    auto* const question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    asked = question != nullptr;
    if (asked) question->button(QMessageBox::No)->click();
  });
  button("work")->click();
  EXPECT_TRUE(asked);
  QTest::qWait(200);
  EXPECT_EQ(recipes_->goals(), before);
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

TEST_F(ASeat, CleansTheScanInViewByHandAndSavesItIntoTheRecipe) {
  EXPECT_FALSE(button("save_edits")->isEnabled()) << "there is no scan";
  scan_to(RunSummary::ACCEPTED);
  ASSERT_TRUE(comes([this] { return text("clean_count") == "1000 of 1000 points stay."; }))
      << text("clean_count");
  cloud_preprocess::HalfSpace half;  // of the fake's lattice 5 of 10 layers
  half.point.z() = 0.0045;
  edits_.add({false, half});
  ASSERT_TRUE(comes([this] { return text("clean_count") == "500 of 1000 points stay."; }));
  auto* const edits = find<QListWidget>("edits");
  EXPECT_EQ(edits->item(0)->text(), "delete plane: 500 points went");
  find<QTabWidget>("pages")->setCurrentIndex(1);
  click("undo");
  ASSERT_TRUE(comes([this] { return text("clean_count") == "1000 of 1000 points stay."; }));
  click("redo");
  ASSERT_TRUE(comes([this] { return text("clean_count") == "500 of 1000 points stay."; }));
  click("save_edits");
  ASSERT_TRUE(comes([this] { return text("clean_end").find("Saved") == 0; })) << trouble();
  EXPECT_EQ(recipes_->last_edit().recipe, "frame");
  EXPECT_EQ(recipes_->last_edit().edits, cloud_preprocess::to_yaml({{false, half}}));
  click("drop_edits");
  EXPECT_TRUE(comes([&] { return edits->count() == 0; }));
}

TEST_F(ASeat, SaysWhyAnEditIsNotDoneAndTakesTheSettingsOfTheNext) {
  scan_to(RunSummary::ACCEPTED);
  ASSERT_TRUE(comes([this] { return edits_.view() != nullptr; }));
  find<QComboBox>("edit_what")->setCurrentIndex(1);
  find<QDoubleSpinBox>("edit_radius")->setValue(2.5);
  EXPECT_EQ(edits_.settings().act, EditAct::kKeepOnly);
  EXPECT_NEAR(edits_.settings().radius, 0.0025, 1e-12);
  cloud_preprocess::BrushShape beside;
  beside.places = {{1, 1, 1}};
  beside.radius = edits_.settings().radius;
  edits_.apply(beside);
  EXPECT_TRUE(comes([this] {
    return text("clean_end").find("leaves nothing") != std::string::npos;
  })) << text("clean_end");
  EXPECT_EQ(text("clean_count"), "1000 of 1000 points stay.");
}

TEST_F(ASeat, HidesPointsOfTheScanWithoutAnEdit) {
  scan_to(RunSummary::ACCEPTED);
  ASSERT_TRUE(comes([this] { return edits_.view() != nullptr; }));
  EXPECT_FALSE(button("show_hidden")->isEnabled());
  cloud_preprocess::HalfSpace half;  // of the fake's lattice 5 of 10 layers
  half.point.z() = 0.0045;
  find<QComboBox>("edit_what")->setCurrentIndex(3);  // show only
  edits_.apply(half);
  const std::string hidden = "1000 of 1000 points stay. 500 of them are hidden.";
  ASSERT_TRUE(comes([&] { return text("clean_count") == hidden; })) << text("clean_count");
  find<QComboBox>("edit_what")->setCurrentIndex(2);  // hide
  edits_.apply(half);
  EXPECT_TRUE(comes([this] {
    return text("clean_end").find("nothing in view") != std::string::npos;
  })) << text("clean_end");
  EXPECT_EQ(find<QListWidget>("edits")->count(), 0);
  edits_.add({true, half});
  EXPECT_TRUE(comes([this] {
    const auto* const item = find<QListWidget>("edits")->item(0);
    return item != nullptr &&
           item->text() == "keep only plane: 500 points went, 500 of them hidden";
  }));
  find<QTabWidget>("pages")->setCurrentIndex(1);
  click("undo");
  ASSERT_TRUE(comes([&] { return text("clean_count") == hidden; })) << text("clean_count");
  click("show_hidden");
  EXPECT_TRUE(comes([this] { return text("clean_count") == "1000 of 1000 points stay."; }));
}

TEST_F(ASeat, TakesOverTheEditsThatTheRecipeHas) {
  scan_to(RunSummary::ACCEPTED);
  find<QTabWidget>("pages")->setCurrentIndex(1);
  ASSERT_TRUE(comes([this] { return button("take_over_edits")->isVisible(); }));
  click("take_over_edits");
  EXPECT_TRUE(comes([this] { return text("clean_count") == "900 of 1000 points stay."; }))
      << text("clean_count");
  EXPECT_FALSE(button("take_over_edits")->isVisible()) << "they are in the list";
}

TEST_F(ASeat, ShowsWhatTheStagesWouldTakeAndSavesThemIntoTheRecipe) {
  scan_to(RunSummary::ACCEPTED);
  ASSERT_TRUE(
      comes([this] { return edits_.view() != nullptr && button("save_edits")->isEnabled(); }));
  find<QTabWidget>("pages")->setCurrentIndex(1);
  EXPECT_EQ(text("stage_floor"), "floor: not tried");
  find<QGroupBox>("stages")->setChecked(true);
  // The recipe cuts the lowest of ten layers.
  ASSERT_TRUE(comes([this] { return text("stage_floor").find("floor: 100 points") == 0; }))
      << text("stage_floor");
  EXPECT_EQ(find<QDoubleSpinBox>("outliers_neighbours")->value(), 5);
  EXPECT_EQ(find<QDoubleSpinBox>("isolate_gap")->suffix().toStdString(), " mm");
  EXPECT_EQ(edits_.view()->kept.size(), 1000u) << "nothing has gone yet";
  ASSERT_EQ(edits_.view()->stages.size(), 3u);
  const EditedViewPtr view = edits_.view();
  for (const std::uint32_t i : view->stages[0].points)
    ASSERT_LT((*view->source)[i].z, 0.0005F);
  find<QDoubleSpinBox>("isolate_min_points")->setValue(1000);  // more than are left
  ASSERT_TRUE(comes([this] { return text("stage_isolate").find("1000") != std::string::npos; }))
      << text("stage_isolate");
  find<QDoubleSpinBox>("isolate_gap")->setValue(12.5);
  click("save_stages");
  ASSERT_TRUE(comes([this] { return text("clean_end").find("Saved") == 0; })) << trouble();
  const auto saved = recipes_->last_edit();
  EXPECT_EQ(saved.what, scan_cell_msgs::EditRecipeRequest::STAGES);
  const auto parameters = cloud_preprocess::read_clean_parameters(
      scan_cell_common::YamlEntry::parse(saved.stages, "saved"));
  EXPECT_FALSE(parameters.floor.automatic);
  EXPECT_EQ(parameters.floor.limits.z_min, 0.0005);
  EXPECT_EQ(parameters.outliers.neighbours, 5);
  EXPECT_EQ(parameters.isolate.min_points, 1000);
  EXPECT_DOUBLE_EQ(parameters.isolate.gap, 0.0125);
  EXPECT_EQ(parameters.floor.margin, cloud_preprocess::FloorParameters().margin);
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

TEST_F(ASeat, LetsAPersonWithANameApproveAnAcceptedRunAndThenWork) {
  scan_to(RunSummary::ACCEPTED);
  EXPECT_FALSE(button("approve")->isEnabled()) << "who?";
  EXPECT_FALSE(button("dry_run")->isEnabled());
  seat_.set_person("Ada");
  find<QLineEdit>("decision_note")->setText("looks good");
  click("approve");
  ASSERT_TRUE(comes([this] { return text("decision") == "Approved by Ada: looks good"; }))
      << text("decision");
  EXPECT_EQ(recipes_->last_decision().run, "run_1");
  EXPECT_EQ(recipes_->last_decision().name, "Ada");
  find<QTabWidget>("pages")->setCurrentIndex(4);
  ASSERT_TRUE(comes([this] { return button("dry_run")->isEnabled(); }));
  click("dry_run");
  ASSERT_TRUE(comes([this] { return recipes_->goals() == 2; }));
  EXPECT_EQ(recipes_->last_goal().run, "run_1");
  EXPECT_EQ(recipes_->last_goal().work, scan_cell_msgs::RunRecipeGoal::DRY_RUN);
  recipes_->finish(RunSummary::ACCEPTED);
  EXPECT_TRUE(comes([this] {
    return text("work_end") == "Done, the dry run. all waypoints were passed";
  })) << text("work_end");
}

TEST_F(ASeat, PreviewsTheWorkBeforeAnythingMoves) {
  QSignalSpy chosen(&seat_, &Seat::poseChosen);
  EXPECT_FALSE(button("preview")->isEnabled()) << "of no run";
  scan_to(RunSummary::ACCEPTED);
  find<QTabWidget>("pages")->setCurrentIndex(4);
  ASSERT_TRUE(comes([this] { return button("preview_dry")->isEnabled(); }));
  EXPECT_FALSE(find<QSlider>("pose")->isEnabled());
  click("preview_dry");
  ASSERT_TRUE(comes([this] { return find<QSlider>("pose")->isEnabled(); })) << trouble();
  EXPECT_EQ(recipes_->last_preview().run, "run_1");
  EXPECT_NE(recipes_->last_preview().dry_run, 0);
  EXPECT_EQ(recipes_->goals(), 1) << "the scan alone";
  EXPECT_EQ(find<QSlider>("pose")->maximum(), 4);
  EXPECT_EQ(chosen.count(), 1) << "the ghost does not come";
  find<QSlider>("pose")->setValue(2);
  EXPECT_EQ(chosen.last().at(0).toInt(), 2);
  EXPECT_NE(text("at_pose").find("Dry run. The robot cannot follow"), std::string::npos)
      << text("at_pose");
  EXPECT_NE(text("at_pose").find("waypoint 1: 30 mm/s"), std::string::npos) << text("at_pose");
  QSignalSpy place(&seat_, &Seat::placeChosen);
  ASSERT_EQ(find<QListWidget>("faults")->count(), 1);
  find<QListWidget>("faults")->setCurrentRow(0);
  EXPECT_EQ(find<QSlider>("pose")->value(), 4);
  ASSERT_EQ(place.count(), 1) << "the view does not turn there";
  EXPECT_EQ(place.at(0).at(0).toDouble(), 0.4);
}

scan_cell_msgs::DescribeRunResponse accepted(const std::string& id) {
  scan_cell_msgs::DescribeRunResponse run;
  run.run.id = id;
  run.run.state = RunSummary::ACCEPTED;
  return run;
}

TEST(WorkPage, MayPreviewAnotherRunThatIsOpenedBeforeThePreviewComes) {
  WorkPage page;
  page.set_free(true);
  page.show_run(accepted("run_1"));
  auto* const preview = page.findChild<QPushButton*>("preview");
  preview->click();
  EXPECT_FALSE(preview->isEnabled()) << "one was asked for";
  page.show_run(accepted("run_1"));
  EXPECT_FALSE(preview->isEnabled()) << "it is the same run";
  page.show_run(accepted("run_2"));
  EXPECT_TRUE(preview->isEnabled());
}

TEST(WorkPage, PutsTheGhostToTheLastPoseOfAShorterPreview) {
  WorkPage page;
  page.show_run(accepted("run_1"));
  QSignalSpy chosen(&page, &WorkPage::poseChosen);
  auto longer = made_preview(), shorter = made_preview();
  shorter.waypoints.resize(3);
  page.show_preview(boost::make_shared<scan_cell_msgs::WorkPreview>(longer));
  EXPECT_EQ(chosen.count(), 0) << "nobody asked for it";
  page.findChild<QSlider*>("pose")->setValue(4);
  page.show_preview(boost::make_shared<scan_cell_msgs::WorkPreview>(shorter));
  ASSERT_EQ(chosen.count(), 2);
  EXPECT_EQ(chosen.last().at(0).toInt(), 2);
}

TEST_F(ASeat, TellsBeforeTheWorkWhichJointTurnsMost) {
  scan_to(RunSummary::ACCEPTED);
  find<QTabWidget>("pages")->setCurrentIndex(4);
  EXPECT_EQ(text("most_turned"), "");
  ASSERT_TRUE(comes([this] { return button("preview")->isEnabled(); }));
  click("preview");
  // The fake's J2 goes from -0.2 to -0.6 rad
  const std::string turn = "J2 turns most along the path: from -11 to -34 degrees";
  const std::string range = "; its range is -57 to 115 degrees.";  // 1 and 2 rad
  EXPECT_TRUE(comes([&] { return text("most_turned") == turn + range; })) << text("most_turned");
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
