// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <QApplication>
#include <QWheelEvent>

#include "fixtures/a_seat.h"

namespace scan_cell_rviz {
namespace {

using scan_cell_msgs::DesignPathRequest;

class ADesignPage : public ASeat {
 protected:
  ADesignPage() {
    find<QTabWidget>("pages")->setCurrentIndex(7);
    choose("design_recipe", 0);
    EXPECT_TRUE(comes([this] { return picks_.is_open(); })) << text("design_end");
  }

  void choose(const char* box, int row) const {
    auto* const combo = find<QComboBox>(box);
    combo->setCurrentIndex(row);
    Q_EMIT combo->activated(row);
  }

  /// Picks from above, as the view's tool does.
  bool pick(double x, double y) {
    Ray ray;
    ray.origin = {x, y, 1};
    ray.direction = {0, 0, -1};
    return picks_.pick(ray);
  }

  bool says_now(const std::string& words) const {
    return text("design_end").find(words) != std::string::npos;
  }
  bool says(const std::string& words) {
    return comes([&] { return says_now(words); });
  }
};

TEST_F(ADesignPage, MakesThePathAnewWithEachPick) {
  EXPECT_FALSE(button("make_path")->isEnabled());
  EXPECT_TRUE(pick(0.01, 0.02));
  EXPECT_FALSE(pick(0.2, 0.02)) << "beside the reference";
  EXPECT_TRUE(pick(0.04, 0.06));
  EXPECT_TRUE(says("2 waypoints in 1 segments, 50.0 mm long")) << text("design_end");
  EXPECT_EQ(text("pick_count"), "2 places picked");
  EXPECT_TRUE(pick(0.04, 0.07));
  EXPECT_TRUE(says("60.0 mm long"));
  click("undo_pick");
  EXPECT_TRUE(says("50.0 mm long"));
  click("redo_pick");
  EXPECT_TRUE(says("60.0 mm long"));
  EXPECT_NEAR(recipes_->last_design().picks.at(2).y, 0.07, 1e-12);
  EXPECT_EQ(recipes_->last_design().recipe, "frame");
}

TEST_F(ADesignPage, GivesTheToolWhatDiffersFromTheDefaultsInItsUnits) {
  ASSERT_TRUE(
      comes([this] { return seat_.findChild<QLineEdit*>("parameter_max_step") != nullptr; }));
  EXPECT_EQ(find<QLineEdit>("parameter_max_step")->text(), "10") << "mm";
  find<QLineEdit>("parameter_max_step")->setText("2.5");
  choose("parameter_closed", 1);
  ASSERT_TRUE(pick(0.01, 0.02) && pick(0.04, 0.06));
  ASSERT_TRUE(says("50.0 mm"));
  const DesignPathRequest request = recipes_->last_design();
  EXPECT_EQ(request.parameter_names, (std::vector<std::string>{"closed", "max_step"}));
  EXPECT_EQ(request.parameter_values, (std::vector<std::string>{"true", "0.0025"}));
  choose("design_way", 1);
  ASSERT_TRUE(comes([this] { return seat_.findChild<QComboBox*>("parameter_closed") == nullptr; }));
  EXPECT_EQ(find<QLineEdit>("parameter_max_step")->text(), "2.5") << "it is still there";
  EXPECT_TRUE(recipes_->last_design().picks.empty()) << "an edge has none";
  EXPECT_TRUE(button("make_path")->isEnabled());
}

TEST_F(ADesignPage, ChangesNoParameterForWhoScrollsOverOneThatCameLater) {
  ASSERT_TRUE(comes([this] {
    const auto* const box = seat_.findChild<QComboBox*>("parameter_closed");
    return box != nullptr && box->isVisible();
  }));
  auto* const closed = find<QComboBox>("parameter_closed");
  const auto turn = [closed] {
    QWheelEvent event(QPointF(2, 2), closed->mapToGlobal(QPoint(2, 2)), {}, QPoint(0, -120),
                      Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(closed, &event);
  };
  turn();
  EXPECT_EQ(closed->currentText(), "false");
  QApplication::setActiveWindow(&seat_);
  closed->setFocus();
  ASSERT_TRUE(comes([closed] { return closed->hasFocus(); }));
  turn();
  EXPECT_EQ(closed->currentText(), "true") << "this one was chosen";
}

TEST_F(ADesignPage, SaysWhichPickIsOfNoUse) {
  ASSERT_TRUE(pick(0.01, -0.02) && pick(0.04, 0.06));
  EXPECT_TRUE(says("pick 1: 3 mm from the surface")) << text("design_end");
  EXPECT_FALSE(says_now("waypoints"));
}

TEST_F(ADesignPage, LeavesTheReferenceOfAnotherSeatsRecipeAlone) {
  visualization_msgs::MarkerPtr other(new visualization_msgs::Marker);
  other->text = "old <b>part</b>";
  other->header.frame_id = "elsewhere";
  Q_EMIT links_.design.referenceCame(other);
  EXPECT_EQ(picks_.frame(), "world");
}

TEST_F(ADesignPage, KeepsThePicksWhereTheSameRecipeIsChosenAgain) {
  ASSERT_TRUE(pick(0.01, 0.02));
  choose("design_recipe", 0);
  EXPECT_EQ(picks_.picks().size(), 1u);
}

TEST_F(ADesignPage, SaysWhyThereIsNoPathAndKeepsThePicks) {
  Ray from_below;
  from_below.origin = {0.05, 0.05, -1};
  ASSERT_TRUE(picks_.pick(from_below)) << "from either side";
  ASSERT_TRUE(pick(0.04, 0.06));
  ASSERT_TRUE(says("waypoints"));
  recipes_.reset();
  click("make_path");
  EXPECT_TRUE(says("/part_recipes/design")) << text("design_end");
  EXPECT_EQ(picks_.picks().size(), 2u);
}

TEST_F(ADesignPage, SavesThePathAsANewRecipeOnceItHasAName) {
  ASSERT_TRUE(pick(0.01, 0.02) && pick(0.04, 0.06));
  EXPECT_FALSE(button("save_design")->isEnabled());
  find<QLineEdit>("design_name")->setText(" another ");
  click("save_design");
  EXPECT_TRUE(says("Saved as another")) << text("design_end");
  EXPECT_EQ(recipes_->last_design().save_as, "another");
}

TEST_F(ADesignPage, BeginsAnewOnAnotherReference) {
  ASSERT_TRUE(pick(0.01, 0.02));
  choose("design_recipe", 1);
  EXPECT_TRUE(picks_.picks().empty());
  EXPECT_TRUE(comes([this] { return recipes_->last_design().recipe == "old <b>part</b>"; }));
  EXPECT_FALSE(button("undo_pick")->isEnabled());
}

}  // namespace
}  // namespace scan_cell_rviz
