// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
// The work on a part, previewed and started with a person's clicks.
#include <QApplication>
#include <QMessageBox>
#include <QSignalSpy>
#include <QTimer>

#include "fixtures/a_seat.h"
#include "fixtures/made_preview.h"
#include "pages/shift/work_page.h"

namespace scan_cell_rviz {
namespace {

using scan_cell_msgs::RunSummary;

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
    return text("work_end") == "Dry run done. all waypoints were passed";
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

}  // namespace
}  // namespace scan_cell_rviz
