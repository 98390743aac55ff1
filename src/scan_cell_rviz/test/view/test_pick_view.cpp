// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
// Places of a path picked in an rviz view, seen from above.
#include <gtest/gtest.h>
#include <rviz/tool_manager.h>

#include "design/pick_session.h"
#include "fixtures/rviz_view.h"

namespace scan_cell_rviz {
namespace {

/// A triangle that rises along x from 0 to 50 mm, over a flat one.
visualization_msgs::MarkerPtr made_reference() {
  visualization_msgs::MarkerPtr reference(new visualization_msgs::Marker);
  reference->header.frame_id = "world";
  reference->points.resize(6);
  for (std::size_t first : {0, 3}) {
    reference->points[first + 1].x = 0.1;
    reference->points[first + 2].y = 0.1;
  }
  reference->points[1].z = 0.05;
  return reference;
}

TEST(PickInView, IsThePlaceOfTheReferenceThatIsSeenThere) {
  constexpr double kScale = 2000;  // [pixels/m]
  RvizView view;
  view.manager.getViewManager()->getCurrent()->subProp("Scale")->setValue(kScale);
  ASSERT_TRUE(view.start());
  QTest::qWait(200);  // the camera follows the view's settings when it is drawn
  rviz::Tool* const tool = view.manager.getToolManager()->addTool("scan_cell_rviz/Pick");
  PickSession& session = shared_pick_session();
  session.open(made_reference());
  view.mouse(tool, QEvent::MouseButtonPress, {0.04, 0.02, 0});
  view.mouse(tool, QEvent::MouseButtonPress, {-0.02, 0.02, 0});
  view.mouse(tool, QEvent::MouseButtonPress, {0.01, 0.05, 0}, Qt::AltModifier);
  ASSERT_EQ(session.picks().size(), 1u) << "neither beside it nor where Alt turns the view";
  constexpr double kPixel = 1 / kScale;
  EXPECT_NEAR(session.picks()[0].x(), 0.04, kPixel);
  EXPECT_NEAR(session.picks()[0].y(), 0.02, kPixel);
  EXPECT_NEAR(session.picks()[0].z(), 0.02, kPixel) << "not on what is hidden below";
}

}  // namespace
}  // namespace scan_cell_rviz
