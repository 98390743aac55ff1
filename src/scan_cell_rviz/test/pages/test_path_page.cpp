// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
// The path of a run edited by hand, with a person's clicks.
#include <QSignalSpy>

#include "fixtures/a_seat.h"

namespace scan_cell_rviz {
namespace {

using scan_cell_msgs::RunSummary;

class APathPage : public ASeat {
 protected:
  APathPage() {
    scan_to(RunSummary::ACCEPTED);
    EXPECT_TRUE(comes([this] { return text("path_count") == "5 waypoints"; }));
    find<QTabWidget>("pages")->setCurrentIndex(3);
  }

  QTableView* table() const { return find<QTableView>("path_waypoints"); }
  std::string cell(int row, int column) const {
    return table()->model()->index(row, column).data().toString().toStdString();
  }
  void choose(int first, int last) const {
    const auto* const model = table()->model();
    table()->selectionModel()->select(
        {model->index(first, 0), model->index(last, 0)},
        QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
  }
  int edits() const { return find<QListWidget>("path_edits")->count(); }
};

TEST_F(APathPage, ShowsEachWaypointWithWhatIsKnownOfIt) {
  ASSERT_EQ(table()->model()->rowCount(), 5);
  EXPECT_EQ(cell(3, 0), "web");
  EXPECT_EQ(cell(3, 2), "30.00");
  EXPECT_EQ(cell(3, 5), "0.400");
  EXPECT_EQ(table()->model()->headerData(6, Qt::Horizontal).toString(), "speed");
  EXPECT_EQ(cell(3, 6), "0.05");
  EXPECT_FALSE(button("move_waypoints")->isEnabled()) << "none is chosen";
  EXPECT_FALSE(button("save_path")->isEnabled()) << "nothing was done";
}

TEST_F(APathPage, TurnsTheViewToTheWaypointThatIsChosen) {
  QSignalSpy places(&seat_, &Seat::placeChosen);
  choose(1, 2);
  ASSERT_EQ(places.count(), 1);
  EXPECT_EQ(places[0][0].toDouble(), 0.02);
  EXPECT_EQ(places[0][3].toString(), "world");
}

TEST_F(APathPage, MovesTurnsAddsDeletesAndSetsWhatIsChosenAndTakesItBack) {
  choose(1, 1);
  find<QDoubleSpinBox>("move_z")->setValue(-2);
  click("move_waypoints");
  EXPECT_EQ(cell(1, 4), "-2.00");
  EXPECT_EQ(cell(1, 1), "edited");
  find<QDoubleSpinBox>("turn_angle")->setValue(90);
  click("turn_waypoints");  // about x: the tool's z axis then points along -y
  find<QDoubleSpinBox>("move_z")->setValue(5);
  click("move_waypoints");
  EXPECT_EQ(cell(1, 3), "-5.00");
  click("add_waypoint");
  EXPECT_EQ(cell(2, 1), "added");
  EXPECT_EQ(cell(2, 2), "15.00");
  EXPECT_EQ(path_.selected()->first, 2u) << "what was added is chosen";
  choose(3, 5);
  click("delete_waypoints");
  EXPECT_EQ(table()->model()->rowCount(), 3);
  choose(0, 0);
  find<QComboBox>("value_name")->setCurrentText("air");
  find<QDoubleSpinBox>("value")->setValue(1);
  click("set_value");
  EXPECT_EQ(cell(0, 7), "1");
  EXPECT_EQ(cell(2, 7), "0");
  EXPECT_EQ(edits(), 7) << "a value that the path did not have is set for all first";
  for (int i = 0; i < 7; ++i)
    click("undo_path");
  EXPECT_EQ(table()->model()->rowCount(), 5);
  EXPECT_EQ(cell(1, 4), "0.00");
  EXPECT_FALSE(button("undo_path")->isEnabled());
  for (int i = 0; i < 7; ++i)
    click("redo_path");
  EXPECT_EQ(table()->model()->rowCount(), 3);
  EXPECT_FALSE(button("redo_path")->isEnabled());
}

TEST_F(APathPage, SaysWhyAnEditIsNotDoneAndKeepsWhatWasDone) {
  choose(0, 0);
  click("move_waypoints");
  choose(0, 4);
  click("delete_waypoints");
  EXPECT_NE(text("path_end").find("deletes all waypoints"), std::string::npos) << text("path_end");
  EXPECT_EQ(edits(), 1);
  EXPECT_EQ(table()->model()->rowCount(), 5);
}

TEST_F(APathPage, MakesARunOfItsOwnAndKeepsTheEditsWhereThatFails) {
  choose(4, 4);
  click("delete_waypoints");
  find<QLineEdit>("path_note")->setText("clamp there");
  const int before = recipes_->goals();
  click("save_path");
  ASSERT_TRUE(comes([&] { return recipes_->goals() > before; })) << trouble();
  EXPECT_EQ(recipes_->last_goal().run, "run_1");
  EXPECT_EQ(recipes_->last_goal().note, "clamp there");
  EXPECT_EQ(recipes_->last_goal().path_edits,
            tool_paths::to_yaml({tool_paths::DeleteEdit{{4, 4}}}));
  EXPECT_FALSE(button("save_path")->isEnabled()) << "one at a time";
  recipes_->finish(RunSummary::UNUSABLE);
  ASSERT_TRUE(comes([this] { return button("save_path")->isEnabled(); }));
  EXPECT_EQ(edits(), 1);
  click("save_path");
  ASSERT_TRUE(comes([&] { return recipes_->goals() > before + 1; })) << trouble();
  recipes_->finish(RunSummary::ACCEPTED);
  ASSERT_TRUE(comes([this] { return edits() == 0; })) << "the new run is in view";
  EXPECT_EQ(find<QTabWidget>("pages")->currentIndex(), 2) << "its verdict";
}

TEST_F(APathPage, OfARefusedRunIsEmptyAndWhatWasDoneToAnotherComesBackWithIt) {
  choose(0, 0);
  click("delete_waypoints");
  scan();
  recipes_->finish(RunSummary::REFUSED);
  link_.describe("run_9");
  ASSERT_TRUE(comes([this] { return text("path_count").find("No adapted path") == 0; }));
  EXPECT_FALSE(button("save_path")->isEnabled());
  scan();
  recipes_->finish(RunSummary::ACCEPTED);  // the fake's is run_1 again
  ASSERT_TRUE(comes([this] { return text("path_count") == "4 waypoints"; })) << text("path_count");
  EXPECT_EQ(edits(), 1);
}

}  // namespace
}  // namespace scan_cell_rviz
