// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
// A shift in the simulated cell, from the seat in rviz with the settings of the cell: choose, scan,
// refuse, scan again, approve, dry run, work, history.
#include <gtest/gtest.h>
#include <rviz/display.h>
#include <rviz/display_group.h>
#include <rviz/visualization_frame.h>
#include <rviz/visualization_manager.h>

#include <QApplication>
#include <QScreen>
#include <QTest>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>

#include "scan_cell_common/testing/child_process.h"
#include "seat/seat.h"

namespace scan_cell_rviz {
namespace {

namespace fs = std::filesystem;

#ifdef __SANITIZE_ADDRESS__
constexpr const char* kScanProgram = SLOW_SCAN_PROGRAM;  // everything is several times slower
#else
constexpr const char* kScanProgram = SCAN_PROGRAM;
#endif
constexpr int kPatience = 240000;  // [ms] a scan takes 10 to 20 s, work a bit longer

void rosrun(std::vector<std::string> command) {
  command.insert(command.begin(), "rosrun");
  scan_cell_common::ChildProcess tool(command, true);
  ASSERT_EQ(tool.wait(), 0) << command[1] << ' ' << command[2];
}

/// Done once by a person who teaches the part type: a clean scan of the reference, its path, a
/// recipe.
void make_recipe(const std::string& folder) {
  const std::string cloud = folder + "/part.ply", path = folder + "/path.csv";
  rosrun({"scan_cell", "scan", "--program", kScanProgram, "--clean", cloud});
  rosrun({"scan_cell_sim", "ground_truth", "tool_path", "--world",
          ros::param::param<std::string>("/scan_cell_sim/world", ""), "--part", "frame", "--output",
          path});
  rosrun({"part_recipes", "recipe", "--recipes", folder + "/recipes", "new", "frame", "--reference",
          cloud, "--path", path, "--program", kScanProgram, "--work", "waypoint_z=into_part",
          "--check-program", kScanProgram});
}

class AShift : public testing::Test {
 protected:
  AShift() {
    frame_.setApp(qApp);
    frame_.setSplashPath("");
    frame_.setShowChooseNewMaster(false);
    frame_.initialize(RVIZ_SETTINGS);
    constexpr int kFrameRate = 5;  // [1/s] without a graphics card, beside a running cell
    displays()->subProp("Global Options")->subProp("Frame Rate")->setValue(kFrameRate);
    frame_.resize(1280, 800);  // [pixels]
    frame_.show();
  }

  Seat& seat() const { return *frame_.findChild<Seat*>(); }
  rviz::DisplayGroup* displays() { return frame_.getManager()->getRootDisplayGroup(); }

  /// Whether the display is switched on; fails if it does not exist.
  bool is_shown(const QString& name) {
    for (int i = 0; i < displays()->numDisplays(); ++i)
      if (displays()->getDisplayAt(i)->getName() == name)
        return displays()->getDisplayAt(i)->isEnabled();
    ADD_FAILURE() << "no display " << name.toStdString();
    return false;
  }

  static bool comes(const std::function<bool()>& condition) {
    return QTest::qWaitFor(condition, kPatience);
  }

  std::string text(const char* label) const {
    return seat().findChild<QLabel*>(label)->text().toStdString();
  }

  bool shows(const char* label, const std::string& words) const {
    return comes([&] { return text(label).find(words) != std::string::npos; });
  }

  /// Clicks as soon as possible.
  void click(const char* name) const {
    auto* const button = seat().findChild<QPushButton*>(name);
    ASSERT_TRUE(comes([&] { return button->isEnabled(); }))
        << name << ": " << text("verdict") << "; " << text("message") << "; " << text("trouble");
    auto* const pages = seat().findChild<QTabWidget*>("pages");
    for (int page = 0; page < pages->count(); ++page)
      if (pages->widget(page)->isAncestorOf(button)) pages->setCurrentIndex(page);
    QTest::mouseClick(button, Qt::LeftButton);
  }

  /// [degrees]; parsing stops at the degree sign.
  double second_joint() const { return std::stod(text("joint_2")); }

  /// Moves the robot by a button and back, and records a pose in between.
  void teach_a_pose(const fs::path& file) {
    auto* const pages = seat().findChild<QTabWidget*>("pages");
    for (int i = 0; i < pages->count(); ++i)
      if (pages->widget(i)->findChild<QPushButton*>("jog_plus_2") != nullptr)
        pages->setCurrentIndex(i);
    seat().set_pose_file(QString::fromStdString(file.string()));
    ASSERT_TRUE(comes([this] { return !text("joint_2").empty(); }));
    const double before = second_joint();
    for (const char* name : {"jog_plus_2", "jog_minus_2"}) {
      auto* const button = seat().findChild<QPushButton*>(name);
      const double from = second_joint();
      QTest::mousePress(button, Qt::LeftButton);
      EXPECT_TRUE(comes([&] { return std::abs(second_joint() - from) > 1; }))
          << name << ": " << text("jog_said");
      QTest::mouseRelease(button, Qt::LeftButton);
      EXPECT_TRUE(comes([this] { return text("jog_said").empty(); })) << text("jog_said");
      if (button->objectName() == "jog_plus_2") {
        click("take_pose");
        EXPECT_TRUE(shows("pose_taken", "Pose 1 of")) << text("pose_taken");
        take_picture("teach");
      }
    }
    EXPECT_NEAR(second_joint(), before, 2);
  }

  /// Lifts three waypoints off the part by 1 mm, as a new run.
  void edit_the_path() {
    auto* const table = seat().findChild<QTableView*>("path_waypoints");
    ASSERT_GT(table->model()->rowCount(), 10);
    table->selectionModel()->select(
        {table->model()->index(4, 0), table->model()->index(6, 0)},
        QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
    seat().findChild<QDoubleSpinBox*>("move_z")->setValue(-1);
    click("move_waypoints");
    take_picture("path");
    click("save_path");
    ASSERT_TRUE(shows("decision", "Nobody")) << text("path_end") << text("trouble");
    EXPECT_TRUE(shows("verdict", "Accepted")) << text("message");
  }

  void choose(const char* name, int item) const {
    auto* const box = seat().findChild<QComboBox*>(name);
    ASSERT_TRUE(comes([&] { return box->count() > item; })) << name;
    box->setCurrentIndex(item);
    Q_EMIT box->activated(item);
  }

  /// Makes a raster on the reference, and checks the passes, as for another recipe.
  void prepare() {
    constexpr int kRaster = 2, kReachable = 5;
    choose("design_recipe", 0);
    choose("design_way", kRaster);
    click("make_path");
    EXPECT_TRUE(shows("design_end", "waypoints")) << text("design_end");
    take_picture("new_path");
    choose("pass_recipe", 0);
    auto* const poses = seat().findChild<QTableWidget*>("pass_poses");
    const auto is_reached = [&] {
      for (int row = 0; row < poses->rowCount(); ++row)
        if (poses->item(row, kReachable)->text() != "yes") return false;
      return poses->rowCount() > 0;
    };
    EXPECT_TRUE(comes(is_reached)) << poses->rowCount() << " poses";
    click("check_passes");
    take_picture("passes");
  }

  /// Saves a picture for the docs in the folder SEAT_PICTURES, if that is set.
  void take_picture(const std::string& name) {
    const char* const folder = std::getenv("SEAT_PICTURES");
    if (folder == nullptr) return;
    QTest::qWait(1500);  // until it is laid out and drawn
    const QPixmap picture = QApplication::primaryScreen()->grabWindow(frame_.winId());
    EXPECT_TRUE(picture.save(QString::fromStdString(folder + ("/seat_" + name + ".png"))));
  }

  EditSession& edits_ = shared_edit_session();
  rviz::VisualizationFrame frame_;
};

TEST_F(AShift, FromThePartOnTheTableToWork) {
  const fs::path folder =
      fs::path(ros::param::param<std::string>("/part_recipes/runs", "")).parent_path();
  ASSERT_TRUE(fs::create_directories(folder / "recipes"));
  ASSERT_NO_FATAL_FAILURE(make_recipe(folder.string()));
  auto* const recipes = seat().findChild<QListWidget*>("recipes");
  ASSERT_TRUE(comes([&] {
    click("refresh");
    QTest::qWait(200);
    return recipes->count() == 1;
  })) << text("missed");
  recipes->setCurrentRow(0);
  for (const char* device : {"sign_robot", "sign_cell"})
    EXPECT_TRUE(shows(device, "ready")) << text(device);
  EXPECT_FALSE(recipes->item(0)->icon().isNull()) << "a person knows the part by its picture";

  EXPECT_LE(frame_.height(), 800) << "a screen may be that low";
  take_picture("part");

  teach_a_pose(folder / "poses.csv");

  click("run");
  EXPECT_TRUE(shows("sign_laser", "ON:")) << "a laser is on and nobody is told";
  take_picture("scan");
  ASSERT_TRUE(shows("verdict", "Accepted")) << text("message") << text("trouble");
  EXPECT_TRUE(shows("sign_laser", "off"));
  EXPECT_TRUE(is_shown("run, object by its deviation"));
  EXPECT_FALSE(is_shown("growing cloud")) << "it lies over the run";
  seat().set_person("Ada");
  click("refuse");
  ASSERT_TRUE(shows("decision", "Refused by Ada"));
  take_picture("refused");

  // the rim of the floor, away from the part
  ASSERT_TRUE(comes([this] { return edits_.view() != nullptr; }));
  cloud_preprocess::HalfSpace rim;
  rim.normal = Eigen::Vector3d::UnitX();
  for (const auto& point : *edits_.view()->source)
    rim.point.x() = std::max(rim.point.x(), point.x - 0.005);
  edits_.add({false, rim});
  ASSERT_TRUE(comes([this] { return edits_.view()->edits.size() == 1; }));
  EXPECT_FALSE(edits_.view()->last.empty());
  click("save_edits");
  ASSERT_TRUE(shows("clean_end", "Saved")) << text("clean_end") << text("trouble");
  EXPECT_TRUE(is_shown("scan under edit by hand (page Clean)"));
  take_picture("clean");
  EXPECT_FALSE(seat().findChild<QPushButton*>("work")->isEnabled());

  click("run");
  ASSERT_TRUE(shows("decision", "Nobody")) << text("message") << text("trouble");
  click("approve");
  ASSERT_TRUE(shows("decision", "Approved by Ada"));
  take_picture("fit");
  edit_the_path();
  click("approve");
  ASSERT_TRUE(shows("decision", "Approved by Ada"));
  click("preview_dry");
  ASSERT_TRUE(shows("at_pose", "Dry run. The robot can follow the whole way"))
      << text("at_pose") << text("trouble");
  seat().findChild<QSlider*>("pose")->setValue(20);
  EXPECT_TRUE(shows("at_pose", "waypoint 19:")) << "after one approach: " << text("at_pose");
  click("work");
  ASSERT_TRUE(shows("work_end", "Not completed")) << "it was never run dry";
  take_picture("not_worked");
  click("dry_run");
  ASSERT_TRUE(shows("work_end", "Dry run done")) << text("work_end") << text("trouble");
  click("work");
  ASSERT_TRUE(comes([this] { return seat().is_busy(); }));
  ASSERT_TRUE(comes([this] { return seat().findChild<QProgressBar*>("progress")->value() > 0; }));
  take_picture("work");
  ASSERT_TRUE(comes([this] { return !seat().is_busy(); }));
  EXPECT_TRUE(shows("work_end", "Done")) << text("work_end");

  click("refresh_runs");
  auto* const runs = seat().findChild<QTableWidget*>("runs");
  EXPECT_TRUE(comes([&] { return runs->rowCount() == 3; }));
  take_picture("history");
  prepare();
  fs::remove_all(folder);
}

}  // namespace
}  // namespace scan_cell_rviz

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "test_shift");
  QApplication application(argc, argv);
  return RUN_ALL_TESTS();
}
