// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
// Measures how long the seat's window does not respond, act by act, with a scan of a million points
// in an rviz view as the cell's settings have it; with its own ROS master and virtual screen, so
// without a graphics card.
#include <fmt/format.h>
#include <ros/ros.h>
#include <rviz/config.h>
#include <rviz/display.h>
#include <rviz/display_group.h>
#include <rviz/tool.h>
#include <rviz/tool_manager.h>
#include <rviz/yaml_config_reader.h>
#include <tf2_ros/static_transform_broadcaster.h>

#include <CLI/CLI.hpp>
#include <QApplication>
#include <QKeyEvent>
#include <QTabWidget>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>

#include "fixtures/hold_ups.h"
#include "fixtures/rviz_view.h"
#include "panel/seat_panel.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/testing/child_process.h"
#include "scan_cell_common/tools/tool_main.h"
#include "view/scan/edit_display.h"

using namespace scan_cell_rviz;  // NOLINT
using Eigen::Vector3d;
using scan_cell_common::ChildProcess;

namespace {

constexpr double kSide = 0.4;  // [m] of the part, seen from above
constexpr double kScale = 1500;
constexpr qint64 kPatienceAct = 60000;  // [ms]
constexpr qint64 kSettle = 500;         // [ms] observed after an act is shown

/// A wavy plate seen from above, with a bar over its middle.
std::shared_ptr<cloud_preprocess::Cloud> made_scan(std::size_t points) {
  auto cloud = std::make_shared<cloud_preprocess::Cloud>();
  const auto rows = static_cast<int>(std::sqrt(static_cast<double>(points)));
  const double step = kSide / rows;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < rows; ++j) {
      const double x = (i + 0.5) * step - kSide / 2;
      const double y = (j + 0.5) * step - kSide / 2;
      const double bar = std::abs(x) < 0.02 ? 0.03 : 0;
      cloud->push_back({static_cast<float>(x), static_cast<float>(y),
                        static_cast<float>(5e-3 * std::sin(40 * x) * std::cos(30 * y) + bar)});
    }
  return cloud;
}

/// Pictures per second in the cell's settings.
int picture_rate() {
  rviz::Config settings;
  rviz::YamlConfigReader().readFile(settings, RVIZ_SETTINGS);
  int rate = 0;
  if (!settings.mapGetChild("Visualization Manager")
           .mapGetChild("Global Options")
           .mapGetInt("Frame Rate", &rate))
    throw scan_cell_common::FileError(RVIZ_SETTINGS, "has no Frame Rate", "set it with rviz");
  return rate;
}

class Workplace {
 public:
  explicit Workplace(std::size_t points) : scan_(made_scan(points)) {
    geometry_msgs::TransformStamped world;
    world.header.frame_id = "world";
    world.child_frame_id = "base_link";
    world.transform.rotation.w = 1;
    frames_.sendTransform(world);
    view_.manager.getRootDisplayGroup()
        ->subProp("Global Options")
        ->subProp("Frame Rate")
        ->setValue(picture_rate());
    view_.manager.getViewManager()->getCurrent()->subProp("Scale")->setValue(kScale);
    display_ = dynamic_cast<EditDisplay*>(
        view_.manager.createDisplay("scan_cell_rviz/EditedScan", "scan", true));
    if (!view_.start())
      throw scan_cell_common::Refused("view", "does not know the frame 'world'", "try again");
    seat_.initialize(&view_.manager);
    seat_.resize(500, 900);  // [pixels]
    seat_.show();
    seat_.findChild<QTabWidget*>("pages")->setCurrentIndex(static_cast<int>(Page::kClean));
  }

  /// Does an act and prints its times.
  void act(const char* name, const std::function<void()>& act, const std::function<bool()>& done) {
    QElapsedTimer since;
    since.start();
    hold_ups_.reset();
    act();
    if (!serve_until([&] { return done() && is_drawn(); }, kPatienceAct))
      throw scan_cell_common::Refused(name, "is not done after a minute", "see what the page says");
    const double shown = static_cast<double>(since.elapsed()) / 1e3;
    since.restart();
    serve_until([&] { return since.elapsed() > kSettle; }, kPatienceAct);
    std::printf("| %s | %.2f | %.0f |\n", name, shown, hold_ups_.longest());
    std::fflush(stdout);
  }

  void all_acts() {
    act(
        "nothing, an empty view", [] {}, [] { return true; });
    act(
        "a scan comes", [this] { edits().open(scan_, "world"); },
        [this] { return seen() == scan_->size(); });
    act(
        "nothing, the scan in view", [] {}, [] { return true; });
    edit_acts();
    stage_acts();
    page_acts();
    seat_.findChild<QTabWidget*>("pages")->setCurrentIndex(static_cast<int>(Page::kClean));
    serve_until([this] { return is_drawn(); }, kPatienceAct);
    std::printf("\nThe view says: %s\n", qPrintable(status_of(*display_, "Scan")));
  }

 private:
  static EditSession& edits() { return shared_edit_session(); }
  static std::size_t seen() {
    const EditedViewPtr view = edits().view();
    return view ? view->shown.size() : 0;
  }
  bool is_drawn() const {
    const EditedViewPtr view = edits().view();
    return !view || !display_->isEnabled() || display_->drawn() == view;
  }

  rviz::Tool* use(const char* name) {
    rviz::Tool* const tool =
        view_.manager.getToolManager()->addTool(QString("scan_cell_rviz/") + name);
    view_.manager.getToolManager()->setCurrentTool(tool);
    return tool;
  }
  void click(rviz::Tool* tool, const Vector3d& place) {
    view_.mouse(tool, QEvent::MouseButtonPress, place);
    view_.mouse(tool, QEvent::MouseButtonRelease, place);
  }
  void set(EditAct act) {
    EditSettings settings;
    settings.act = act;
    edits().set_settings(settings);
  }

  void draw_polygon(rviz::Tool* tool) {
    for (const auto& [x, y] :
         {std::pair(-0.1, -0.1), std::pair(-0.05, -0.1), std::pair(-0.05, 0.1)})
      click(tool, {x, y, 0});
    QKeyEvent enter(QEvent::KeyPress, Qt::Key_Return, Qt::NoModifier);
    tool->processKeyEvent(&enter, &view_.panel);
  }

  void brush(rviz::Tool* tool) {
    constexpr int kMoves = 40;
    view_.mouse(tool, QEvent::MouseButtonPress, {0.1, -0.1, 0});
    for (int i = 1; i <= kMoves; ++i) {
      view_.mouse(tool, QEvent::MouseMove, {0.1, -0.1 + 5e-3 * i, 0});
      QCoreApplication::processEvents();
    }
    view_.mouse(tool, QEvent::MouseButtonRelease, {0.1, 0.1, 0});
  }

  std::size_t edit_count() const { return static_cast<std::size_t>(edits().view()->edits.size()); }

  void edit_acts() {
    rviz::Tool* const polygon = use("Polygon");
    act(
        "polygon, deletes", [&] { draw_polygon(polygon); }, [&] { return edit_count() == 1; });
    rviz::Tool* const brushed = use("Brush");
    act(
        "brush, a stroke of 40 moves", [&] { brush(brushed); }, [&] { return edit_count() == 2; });
    rviz::Tool* const plane = use("Plane");
    const auto three = [&] {
      for (const auto& [x, y] :
           {std::pair(-0.01, -0.1), std::pair(0.01, -0.1), std::pair(0.0, 0.1)})
        click(plane, {x, y, 0.03});
    };
    act("plane, deletes", three, [&] { return edit_count() == 3; });
    act(
        "undo", [] { edits().undo(); }, [&] { return edit_count() == 2; });
    act(
        "redo", [] { edits().redo(); }, [&] { return edit_count() == 3; });
    act(
        "drop all", [] { edits().drop_all(); }, [&] { return edit_count() == 0; });
    set(EditAct::kHide);
    rviz::Tool* const cluster = use("Cluster");
    act(
        "cluster, hides",
        [&] {
          click(cluster, {0, 0, 0.03});
        },
        [this] { return seen() < scan_->size(); });
    act(
        "show hidden", [] { edits().show_all(); }, [this] { return seen() == scan_->size(); });
    set(EditAct::kDelete);
  }

  void stage_acts() {
    auto* const stages = seat_.findChild<QGroupBox*>("stages");
    act(
        "automatic stages, switched on", [&] { stages->setChecked(true); },
        [] { return !edits().view()->stages.empty(); });
    auto* const distance = seat_.findChild<QDoubleSpinBox*>("floor_distance");
    const EditedViewPtr before = edits().view();
    act(
        "a slider of a stage", [&] { distance->setValue(2 * distance->value()); },
        [&] { return edits().view() != before; });
    act(
        "automatic stages, switched off", [&] { stages->setChecked(false); },
        [] { return edits().view()->stages.empty(); });
  }

  void page_acts() {
    auto* const pages = seat_.findChild<QTabWidget*>("pages");
    const auto leaf = [&] {
      for (int i = 0; i < pages->count(); ++i) {
        pages->setCurrentIndex(i);
        QCoreApplication::processEvents();
      }
    };
    act("all pages, one after another", leaf, [] { return true; });
  }

  std::shared_ptr<cloud_preprocess::Cloud> scan_;
  tf2_ros::StaticTransformBroadcaster frames_;
  RvizView view_;
  EditDisplay* display_ = nullptr;
  SeatPanel seat_;
  HoldUps hold_ups_;
};

/// Runs in its own process with a screen and a master.
int run_inside(int argc, char** argv, std::size_t points) {
  ros::init(argc, argv, "bench_seat");
  const ros::NodeHandle node;
  const QApplication application(argc, argv);
  Workplace place(points);
  std::printf(
      "\n%zu points\n\n| act | shown after [s] | longest without an answer [ms] |\n|---|---|---|\n",
      points);
  place.all_acts();
  return 0;
}

int run_all(const std::string& program, std::size_t points) {
  const std::string port = fmt::format("{}", scan_cell_common::free_port());
  setenv("ROS_MASTER_URI", ("http://127.0.0.1:" + port).c_str(), 1);
  setenv("ROS_IP", "127.0.0.1", 1);
  setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
  const ChildProcess master({"rosmaster", "--core", "-p", port}, true);
  ChildProcess run({"xvfb-run", "--auto-servernum", "--server-num", "180", "--server-args",
                    "-screen 0 1600x1000x24", program, "--inside", "--points",
                    fmt::format("{}", points)});
  return run.wait();
}

}  // namespace

int main(int argc, char** argv) {
  const std::string program = std::filesystem::read_symlink("/proc/self/exe");
  std::size_t points = 1'000'000;
  bool inside = false;
  CLI::App app("How long the window of the seat does not answer, act by act.");
  app.add_option("--points", points, "of the scan");
  app.add_flag("--inside", inside, "for the program itself: it has a screen and a ROS master");
  return scan_cell_common::tool_main("bench_seat", app, argc, argv, [&] {
    return inside ? run_inside(argc, argv, points) : run_all(program, points);
  });
}
