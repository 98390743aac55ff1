// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>

#include "fixtures/a_seat.h"

namespace scan_cell_rviz {
namespace {

class APassesPage : public ASeat {
 protected:
  APassesPage() {
    find<QTabWidget>("pages")->setCurrentIndex(8);
    choose_recipe(0);
    EXPECT_TRUE(comes([this] { return table()->rowCount() == 5; })) << text("pass_end");
  }

  void choose_recipe(int row) const {
    auto* const box = find<QComboBox>("pass_recipe");
    box->setCurrentIndex(row);
    Q_EMIT box->activated(row);
  }
  QTableWidget* table() const { return find<QTableWidget>("pass_poses"); }
  std::string cell(int row, int column) const {
    return table()->item(row, column)->text().toStdString();
  }
  bool says(int row, const std::string& reach) {
    return comes([&] { return cell(row, 5) == reach; });
  }

  /// Moves a pose as the handles in the view do.
  void drag(const PassPose& at, const Eigen::Vector3d& to) {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.translation() = to;
    passes_.move(at, pose);
  }
};

TEST_F(APassesPage, ListsThePosesOfEachPassAndWhetherTheRobotReachesThem) {
  EXPECT_EQ(cell(0, 0), "flank");
  EXPECT_EQ(cell(1, 1), "end");
  EXPECT_EQ(cell(1, 2), "300.0");
  EXPECT_EQ(cell(2, 0), "2") << "it has no name";
  EXPECT_EQ(cell(3, 1), "via");
  EXPECT_TRUE(says(0, "yes"));
  EXPECT_TRUE(says(4, "yes"));
}

TEST_F(APassesPage, AsksTheCellAnewForWhatIsDragged) {
  ASSERT_TRUE(says(0, "yes"));
  drag({0, 1}, {0.3, 0, 1.2});
  EXPECT_TRUE(says(0, "NO")) << "all of the pass";
  EXPECT_EQ(cell(1, 4), "1200.0");
  EXPECT_EQ(text("pass_reach"), "flank: pass 1: the arm is too short");
  EXPECT_TRUE(says(2, "yes")) << "the other one";
  click("undo_pass");
  EXPECT_TRUE(says(0, "yes"));
  EXPECT_FALSE(button("undo_pass")->isEnabled());
  click("redo_pass");
  EXPECT_TRUE(says(0, "NO"));
}

TEST_F(APassesPage, SaysThatItDoesNotKnowWhereTheCellIsGone) {
  ASSERT_TRUE(says(0, "yes"));
  recipes_.reset();
  click("check_passes");
  EXPECT_TRUE(says(0, "not known"));
  EXPECT_NE(text("pass_reach").find("check_program"), std::string::npos) << text("pass_reach");
}

TEST_F(APassesPage, SavesWhatWasDraggedIntoTheRecipe) {
  EXPECT_FALSE(button("save_passes")->isEnabled());
  drag({1, 1}, {0, 0.12, 0});
  click("save_passes");
  ASSERT_TRUE(comes([this] { return text("pass_end").find("Saved into frame") == 0; }))
      << text("pass_end");
  const auto saved = recipes_->last_program();
  EXPECT_EQ(saved.recipe, "frame");
  EXPECT_EQ(saved.frame, "world");
  EXPECT_EQ(saved.passes.at(1).poses.at(1).position.y, 0.12);
  EXPECT_EQ(saved.passes.at(0).name, "flank");
}

TEST_F(APassesPage, ChoosesAPassForItsHandlesAndTurnsTheViewThere) {
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  QObject::connect(&seat_, &Seat::placeChosen, &seat_, [&](double x, double y, double z) {
    place = {x, y, z};
  });
  table()->selectRow(3);
  ASSERT_TRUE(passes_.selected());
  EXPECT_EQ(passes_.selected()->pass, 1u);
  EXPECT_EQ(passes_.selected()->pose, 1u);
  EXPECT_EQ(place, Eigen::Vector3d(0, 0.1, 0));
}

TEST_F(APassesPage, SaysThatARecipeHasNoProgram) {
  choose_recipe(1);
  EXPECT_TRUE(
      comes([this] { return text("pass_end").find("no scan program") != std::string::npos; }));
  EXPECT_EQ(table()->rowCount(), 0);
  EXPECT_FALSE(button("drag_poses")->isEnabled());
}

}  // namespace
}  // namespace scan_cell_rviz
