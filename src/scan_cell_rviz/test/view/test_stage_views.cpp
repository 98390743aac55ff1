// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
// The displays and the view beside each page.
#include <gtest/gtest.h>

#include <QFile>

#include "fixtures/rviz_view.h"
#include "view/stage/displays.h"
#include "view/stage/stage_views.h"

namespace scan_cell_rviz {
namespace {

using Eigen::Vector3d;

class ViewsByPage : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    view_ = new RvizView;
    view_->manager.getViewManager()->setCurrentViewControllerType("rviz/Orbit");
    live_ = view_->manager.createDisplay("rviz/Axes", "growing cloud", true);
    run_ = view_->manager.createDisplay("rviz/Axes", "run, adapted path", true);
    scan_ = view_->manager.createDisplay("scan_cell_rviz/EditedScan", "any name", true);
    own_ = view_->manager.createDisplay("rviz/Axes", "my own", true);
    ASSERT_TRUE(view_->start());
  }
  static void TearDownTestSuite() { delete view_; }

  ViewsByPage() {
    for (rviz::Display* const display : {live_, run_, scan_, own_})
      display->setEnabled(true);
    stages_.show(Page::kPart);
  }

  static rviz::ViewController& view() { return *view_->manager.getViewManager()->getCurrent(); }
  static rviz::Property* distance() { return view().subProp("Distance"); }

  /// Distance from the middle, as a share of half the view's height or width, whichever is larger;
  /// negative: behind the camera.
  static float off_middle(const Vector3d& place) {
    const Ogre::Camera* const camera = view_->panel.getViewport()->getCamera();
    const Ogre::Vector3 seen =
        camera->getProjectionMatrix() * (camera->getViewMatrix() * to_ogre(place));
    return std::max(std::abs(seen.x), std::abs(seen.y));
  }

  void expect_fit(const QSize& window);

  static RvizView* view_;
  static rviz::Display *live_, *run_, *scan_, *own_;
  StageViews stages_{view_->manager};
};

RvizView* ViewsByPage::view_ = nullptr;
rviz::Display* ViewsByPage::live_ = nullptr;
rviz::Display* ViewsByPage::run_ = nullptr;
rviz::Display* ViewsByPage::scan_ = nullptr;
rviz::Display* ViewsByPage::own_ = nullptr;

TEST_F(ViewsByPage, ShowWhatThePageIsAbout) {
  EXPECT_TRUE(live_->isEnabled()) << "rviz's own settings hold at the first page";
  stages_.show(Page::kFit);
  EXPECT_TRUE(run_->isEnabled());
  EXPECT_FALSE(live_->isEnabled());
  EXPECT_FALSE(scan_->isEnabled());
  stages_.show(Page::kClean);
  EXPECT_FALSE(run_->isEnabled());
  EXPECT_TRUE(scan_->isEnabled());
  stages_.show(Page::kPart);
  EXPECT_TRUE(live_->isEnabled());
}

TEST_F(ViewsByPage, LeaveOtherDisplaysAsTheyAre) {
  stages_.show(Page::kFit);
  EXPECT_TRUE(own_->isEnabled());
  own_->setEnabled(false);
  stages_.show(Page::kClean);
  EXPECT_FALSE(own_->isEnabled());
}

TEST_F(ViewsByPage, AreAsAPersonLeftThem) {
  stages_.show(Page::kFit);
  EXPECT_FALSE(stages_.has_view());
  live_->setEnabled(true);
  distance()->setValue(0.7);
  stages_.show(Page::kClean);
  distance()->setValue(3.0);
  stages_.show(Page::kFit);
  EXPECT_TRUE(stages_.has_view());
  EXPECT_TRUE(live_->isEnabled());
  EXPECT_FLOAT_EQ(distance()->getValue().toFloat(), 0.7F);
}

TEST_F(ViewsByPage, AreKeptWithTheSettingsOfRviz) {
  stages_.show(Page::kFit);
  distance()->setValue(0.7);
  live_->setEnabled(true);
  stages_.show(Page::kWork);
  rviz::Config kept;
  stages_.save(kept);
  distance()->setValue(5.0);
  live_->setEnabled(false);
  StageViews again(view_->manager);
  again.load(kept);
  again.show(Page::kFit);
  EXPECT_FLOAT_EQ(distance()->getValue().toFloat(), 0.7F);
  EXPECT_TRUE(live_->isEnabled());
}

/// Checks in a window of that size.
void ViewsByPage::expect_fit(const QSize& window) {
  view_->panel.resize(window);
  const Vector3d middle(0.4, -0.2, 0.3);
  constexpr double kRadius = 0.15;  // [m]
  const QVariant yaw = view().subProp("Yaw")->getValue();
  ASSERT_TRUE(stages_.fit({middle, kRadius, "world"}));
  EXPECT_EQ(view().subProp("Yaw")->getValue(), yaw) << "seen from another side";
  ASSERT_TRUE(comes([&] { return off_middle(middle) < 0.01F; }));
  const auto farthest = [&] {
    float most = 0;
    for (const Vector3d& way : {Vector3d(1, 0, 0), Vector3d(0, 1, 0), Vector3d(0, 0, 1)})
      for (const double sign : {-1.0, 1.0})
        most = std::max(most, off_middle(middle + sign * kRadius * way));
    return most;
  };
  EXPECT_TRUE(comes([&] { return farthest() < 1; })) << farthest() << ": not all is in view";
  EXPECT_GT(farthest(), 0.5F) << "seen from far off";
}

TEST_F(ViewsByPage, FitThePartIntoAnyWindow) {
  expect_fit({800, 600});
  expect_fit({500, 800});
}

TEST_F(ViewsByPage, AreNotChosenByWhoOnlyPassesBy) {
  stages_.show(Page::kFit);
  stages_.show(Page::kClean);
  stages_.show(Page::kFit);
  EXPECT_FALSE(stages_.has_view()) << "the part comes later, and the view is to go there";
}

TEST_F(ViewsByPage, LetTheCloudGrowOnWhileItIsScanned) {
  stages_.show(Page::kClean, true);
  EXPECT_TRUE(live_->isEnabled()) << "switched off, it would begin anew";
  stages_.show(Page::kFit);
  EXPECT_FALSE(live_->isEnabled());
  stages_.show(Page::kClean);
  EXPECT_FALSE(live_->isEnabled());
}

TEST_F(ViewsByPage, TakeAwayWhatTheSeatMadeForAnotherPage) {
  stages_.show(Page::kPasses);
  rviz::Display* const made =
      view_->manager.createDisplay("rviz/Axes", display_names::kPasses, true);
  stages_.show(Page::kPart);
  EXPECT_FALSE(made->isEnabled());
  stages_.show(Page::kPasses);
  EXPECT_TRUE(made->isEnabled());
  delete made;
}

TEST(KnownDisplays, AreThoseOfTheCellsSettingsAndOfTheSeat) {
  const QStringList of_seat = {display_names::kBox,
                               display_names::kWaypoint,
                               display_names::kPoses,
                               display_names::kPasses,
                               display_names::kDesign,
                               display_names::kDesignPicks,
                               display_names::kDesignReference};
  QFile settings(RVIZ_SETTINGS);
  ASSERT_TRUE(settings.open(QIODevice::ReadOnly));
  const QString text = QString::fromUtf8(settings.readAll());
  for (const QString& name : StageViews::known_displays())
    EXPECT_TRUE(of_seat.contains(name) || text.contains("      Name: " + name + "\n"))
        << name.toStdString();
}

TEST_F(ViewsByPage, StayWhereTheFrameIsNotKnown) {
  const QVariant before = distance()->getValue();
  EXPECT_FALSE(stages_.fit({{1, 0, 0}, 0.1, "nowhere"}));
  EXPECT_EQ(distance()->getValue(), before);
}

}  // namespace
}  // namespace scan_cell_rviz
