// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
// A scan cleaned by hand and by stages, with a person's clicks.
#include "fixtures/a_seat.h"
#include "scan_cell_common/files/yaml_file.h"

namespace scan_cell_rviz {
namespace {

using scan_cell_msgs::RunSummary;

TEST_F(ASeat, CleansTheScanInViewByHandAndSavesItIntoTheRecipe) {
  EXPECT_FALSE(button("save_edits")->isEnabled()) << "there is no scan";
  scan_to(RunSummary::ACCEPTED);
  ASSERT_TRUE(comes([this] { return text("clean_count") == "1000 of 1000 points stay."; }))
      << text("clean_count");
  cloud_preprocess::HalfSpace half;  // 5 of 10 layers of the fake's lattice
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
  cloud_preprocess::HalfSpace half;  // 5 of 10 layers of the fake's lattice
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

}  // namespace
}  // namespace scan_cell_rviz
