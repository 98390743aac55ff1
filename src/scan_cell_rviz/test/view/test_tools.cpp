// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
// The tools in an rviz view, seen from above and moved by the mouse, checked by point counts of a
// lattice.
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <rviz/display.h>
#include <rviz/tool.h>
#include <rviz/tool_manager.h>

#include <QKeyEvent>
#include <memory>

#include "edit/edit_session.h"
#include "fixtures/rviz_view.h"
#include "view/cloud_frame.h"

namespace scan_cell_rviz {
namespace {

using Eigen::Vector3d;

constexpr int kHalf = 20;        // lattice steps to each side
constexpr double kStep = 5e-3;   // [m]
constexpr double kUpper = 0.1;   // [m] height of the upper of two layers
constexpr double kScale = 2000;  // [pixels/m]
constexpr std::size_t kLayer = (2 * kHalf + 1) * (2 * kHalf + 1);

std::shared_ptr<cloud_preprocess::Cloud> two_layers() {
  auto cloud = std::make_shared<cloud_preprocess::Cloud>();
  for (const double z : {0.0, kUpper})
    for (int x = -kHalf; x <= kHalf; ++x)
      for (int y = -kHalf; y <= kHalf; ++y)
        cloud->push_back(
            {static_cast<float>(x * kStep), static_cast<float>(y * kStep), static_cast<float>(z)});
  return cloud;
}

class Tools : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    view_ = new RvizView;
    panel_ = &view_->panel;
    manager_ = &view_->manager;
    manager_->getViewManager()->getCurrent()->subProp("Scale")->setValue(kScale);
    display_ = manager_->createDisplay("scan_cell_rviz/EditedScan", "scan", true);
    ASSERT_TRUE(view_->start());
    QTest::qWait(200);  // the camera follows the view's settings when it is drawn
  }
  static void TearDownTestSuite() { delete view_; }

  Tools() {
    session().set_settings({});
    session().open(two_layers(), "world");
    EXPECT_TRUE(comes([] {
      const EditedViewPtr view = session().view();
      return view && view->edits.isEmpty() && view->kept.size() == 2 * kLayer;
    }));
  }
  ~Tools() override { manager_->getToolManager()->removeAll(); }

  static EditSession& session() { return shared_edit_session(); }

  rviz::Tool* use(const char* name) {
    rviz::Tool* const tool = manager_->getToolManager()->addTool(name);
    manager_->getToolManager()->setCurrentTool(tool);
    return tool;
  }

  void mouse(rviz::Tool* tool, QEvent::Type type, const Vector3d& place) {
    view_->mouse(tool, type, place);
  }

  void click(rviz::Tool* tool, const Vector3d& place) {
    mouse(tool, QEvent::MouseButtonPress, place);
    mouse(tool, QEvent::MouseButtonRelease, place);
  }

  void key(rviz::Tool* tool, int key) {
    QKeyEvent event(QEvent::KeyPress, key, Qt::NoModifier);
    tool->processKeyEvent(&event, panel_);
  }

  static bool took(std::size_t points) {
    return comes([=] { return session().view()->last.size() == points; });
  }

  static RvizView* view_;
  static rviz::RenderPanel* panel_;
  static rviz::VisualizationManager* manager_;
  static rviz::Display* display_;
};

RvizView* Tools::view_ = nullptr;
rviz::RenderPanel* Tools::panel_ = nullptr;
rviz::VisualizationManager* Tools::manager_ = nullptr;
rviz::Display* Tools::display_ = nullptr;

TEST_F(Tools, APolygonTakesWhatIsBehindItToItsDepth) {
  rviz::Tool* const tool = use("scan_cell_rviz/Polygon");
  // around 6 by 6 points; the first corner is on one of them
  for (const auto& [x, y] : {std::pair(-0.016, -0.016), std::pair(0.0125, -0.016),
                             std::pair(0.0125, 0.0125), std::pair(-0.016, 0.0125)})
    click(tool, {x, y, kUpper});
  key(tool, Qt::Key_Return);
  EXPECT_TRUE(took(36)) << session().view()->last.size();
}

TEST_F(Tools, TheDisplayTellsHowMuchStays) {
  const auto told = [] { return status_of(*display_, "Scan"); };
  EXPECT_TRUE(comes([&] { return told() == QString("%1 points stay").arg(2 * kLayer); }))
      << told().toStdString();
  cloud_preprocess::HalfSpace upper;
  upper.point.z() = kUpper / 2;
  session().add({false, upper});
  EXPECT_TRUE(comes([&] { return told() == QString("%1 points stay").arg(kLayer); }))
      << told().toStdString();
}

TEST_F(Tools, APolygonIsBegunAnewByEscape) {
  rviz::Tool* const tool = use("scan_cell_rviz/Polygon");
  click(tool, {0, 0, kUpper});
  click(tool, {0.05, 0, kUpper});
  click(tool, {0.05, 0.05, kUpper});
  key(tool, Qt::Key_Escape);
  key(tool, Qt::Key_Return);
  cloud_preprocess::HalfSpace lower;  // next in the queue
  lower.point.z() = kUpper / 2;
  session().add({true, lower});
  ASSERT_TRUE(took(kLayer));
  EXPECT_EQ(session().view()->edits.size(), 1);
}

TEST_F(Tools, APlaneKeepsTheSideOfTheViewer) {
  EditSettings settings;
  settings.act = EditAct::kKeepOnly;
  session().set_settings(settings);
  rviz::Tool* const tool = use("scan_cell_rviz/Plane");
  click(tool, {-0.05, -0.05, kUpper});
  click(tool, {0.05, -0.05, kUpper});
  click(tool, {0, 0.05, kUpper});
  EXPECT_TRUE(took(kLayer)) << "the lower one: " << session().view()->last.size();
}

TEST_F(Tools, ABrushTakesWhatItGoesOverOfTheSurfaceInFront) {
  EditSettings settings;
  settings.radius = 0.007;  // four neighbours are 5 mm away, the next ones 7.07 mm
  session().set_settings(settings);
  rviz::Tool* const tool = use("scan_cell_rviz/Brush");
  mouse(tool, QEvent::MouseButtonPress, {0, 0, kUpper});
  for (int step = 1; step <= 4; ++step)
    mouse(tool, QEvent::MouseMove, {step * kStep, 0, kUpper});
  mouse(tool, QEvent::MouseButtonRelease, {4 * kStep, 0, kUpper});
  EXPECT_TRUE(took(7 + 2 * 5)) << session().view()->last.size();
}

TEST_F(Tools, AClusterTakesAllThatHangsTogether) {
  EditSettings settings;
  settings.gap = 1.2 * kStep;
  session().set_settings(settings);
  rviz::Tool* const tool = use("scan_cell_rviz/Cluster");
  click(tool, {0, 0, kUpper});
  ASSERT_TRUE(took(kLayer)) << session().view()->last.size();
  EXPECT_EQ(session().view()->kept.size(), kLayer);
}

TEST_F(Tools, AHiddenClusterIsOutOfTheWayAndNotEdited) {
  EditSettings settings;
  settings.gap = 1.2 * kStep;
  settings.act = EditAct::kHide;
  session().set_settings(settings);
  rviz::Tool* const tool = use("scan_cell_rviz/Cluster");
  click(tool, {0, 0, kUpper});
  ASSERT_TRUE(comes([] { return session().view()->shown.size() == kLayer; }));
  EXPECT_EQ(session().view()->kept.size(), 2 * kLayer);
  EXPECT_TRUE(session().view()->edits.isEmpty());
  settings.act = EditAct::kDelete;
  session().set_settings(settings);
  click(tool, {0, 0, 0});  // the upper layer is above it
  ASSERT_TRUE(took(kLayer)) << session().view()->last.size();
  const EditedViewPtr view = session().view();
  for (const std::uint32_t i : view->kept)
    ASSERT_GT((*view->source)[i].z, kUpper / 2);
  session().show_all();
  EXPECT_TRUE(comes([] { return session().view()->shown.size() == kLayer; }));
}

}  // namespace
}  // namespace scan_cell_rviz
