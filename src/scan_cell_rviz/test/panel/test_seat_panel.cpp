// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
// The seat as a panel of an rviz view.
#include <gtest/gtest.h>
#include <rviz/tool_manager.h>

#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QSlider>
#include <QTimer>

#include "fixtures/fake_recipes.h"
#include "fixtures/rviz_view.h"
#include "panel/seat_panel.h"

namespace scan_cell_rviz {
namespace {

class ASeatPanel : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    view_ = new RvizView;
    view_->manager.getViewManager()->setCurrentViewControllerType("rviz/Orbit");
    live_ = view_->manager.createDisplay("rviz/Axes", "growing cloud", true);
    run_ = view_->manager.createDisplay("rviz/Axes", "run, adapted path", false);
    ASSERT_TRUE(view_->start());
  }
  static void TearDownTestSuite() { delete view_; }

  ASeatPanel() {
    live_->setEnabled(true);
    run_->setEnabled(false);
    panel_.initialize(&view_->manager);
    panel_.show();
  }

  template <class Widget>
  static Widget* find(const SeatPanel& panel, const char* name) {
    return panel.findChild<Widget*>(name);
  }
  QTabWidget* pages() const { return find<QTabWidget>(panel_, "pages"); }

  /// Starts a scan.
  void scan() {
    auto* const list = find<QListWidget>(panel_, "recipes");
    ASSERT_TRUE(comes([&] { return list->count() == 2; }));
    list->setCurrentRow(0);
    ASSERT_TRUE(comes([&] {
      QTest::mouseClick(find<QPushButton>(panel_, "run"), Qt::LeftButton);
      QTest::qWait(50);
      return recipes_.goals() == 1;
    }));
  }

  static RvizView* view_;
  static rviz::Display *live_, *run_;
  FakeRecipes recipes_;
  SeatPanel panel_;
};

RvizView* ASeatPanel::view_ = nullptr;
rviz::Display* ASeatPanel::live_ = nullptr;
rviz::Display* ASeatPanel::run_ = nullptr;

/// Closes the window and answers its question.
void close_and_answer(QWidget& window, const QString& answer) {
  bool answered = false;
  QTimer::singleShot(0, [&] {
    auto* const question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    ASSERT_NE(question, nullptr) << "it did not ask";
    for (QAbstractButton* const button : question->buttons()) {
      if (button->text() != answer) continue;
      answered = true;
      button->click();
      return;
    }
    question->reject();
  });
  window.close();
  EXPECT_TRUE(answered) << answer.toStdString();
}

TEST_F(ASeatPanel, AsksBeforeItClosesAmidAScanAndStopsItIfTold) {
  scan();
  close_and_answer(panel_, "&Do not close");
  EXPECT_TRUE(panel_.isVisible());
  EXPECT_FALSE(recipes_.was_cancelled());
  close_and_answer(panel_, "&Stop it and close");
  EXPECT_FALSE(panel_.isVisible());
  EXPECT_TRUE(comes([this] { return recipes_.was_cancelled(); }));
}

TEST_F(ASeatPanel, AsksBeforeEditsAreLost) {
  auto cloud = std::make_shared<cloud_preprocess::Cloud>();
  for (int i = 0; i < 10; ++i)
    cloud->push_back({0.01F * static_cast<float>(i), 0, 0});
  shared_edit_session().open(cloud, "world");
  cloud_preprocess::HalfSpace half;
  half.point.x() = 0.05;
  half.normal = Eigen::Vector3d::UnitX();
  shared_edit_session().add({false, half});
  ASSERT_TRUE(comes([] {
    const EditedViewPtr view = shared_edit_session().view();
    return view && view->edits.size() == 1;
  }));
  close_and_answer(panel_, "&Do not close");
  EXPECT_TRUE(panel_.isVisible());
  close_and_answer(panel_, "&Close without them");
  EXPECT_FALSE(panel_.isVisible());
  shared_edit_session().drop_all();
  EXPECT_TRUE(comes([] { return shared_edit_session().view()->edits.isEmpty(); }));
}

TEST_F(ASeatPanel, ShowsWhatThePageIsAboutInTheView) {
  scan();
  EXPECT_TRUE(live_->isEnabled());
  recipes_.finish(scan_cell_msgs::RunSummary::ACCEPTED);
  EXPECT_TRUE(comes([] { return run_->isEnabled(); })) << "the page of the fit comes by itself";
  EXPECT_FALSE(live_->isEnabled());
  pages()->setCurrentIndex(static_cast<int>(Page::kPart));
  EXPECT_TRUE(live_->isEnabled());
}

TEST_F(ASeatPanel, TakesThePreviewAwayWhereAnotherRunIsChosen) {
  scan();
  recipes_.finish(scan_cell_msgs::RunSummary::ACCEPTED);
  auto* const preview = find<QPushButton>(panel_, "preview");
  ASSERT_TRUE(comes([&] { return preview->isEnabled(); }));
  pages()->setCurrentIndex(static_cast<int>(Page::kWork));
  rviz::Display* const drawn =
      view_->manager.createDisplay("scan_cell_rviz/WorkPreview", "preview", true);
  const auto way = [drawn] { return status_of(*drawn, "Way"); };
  ASSERT_TRUE(comes([&] {  // the display may not be connected yet
    if (preview->isEnabled()) preview->click();
    QTest::qWait(50);
    return way().contains("out of reach");
  })) << way().toStdString();
  auto* const pose = find<QSlider>(panel_, "pose");
  EXPECT_TRUE(pose->isEnabled());
  Q_EMIT panel_.findChild<HistoryPage*>()->runChosen("run_2");
  EXPECT_TRUE(comes([&] { return !pose->isEnabled(); }));
  pages()->setCurrentIndex(static_cast<int>(Page::kWork));
  EXPECT_TRUE(comes([&] { return way().contains("not of this run"); })) << way().toStdString();
}

TEST_F(ASeatPanel, LaysAToolDownThatEditsTheScanWhereItIsNotSeen) {
  pages()->setCurrentIndex(static_cast<int>(Page::kClean));
  QTest::mouseClick(find<QPushButton>(panel_, "tool_brush"), Qt::LeftButton);
  rviz::ToolManager& tools = *view_->manager.getToolManager();
  EXPECT_EQ(tools.getCurrentTool()->getClassId(), "scan_cell_rviz/Brush");
  pages()->setCurrentIndex(static_cast<int>(Page::kFit));
  EXPECT_EQ(tools.getCurrentTool(), tools.getDefaultTool());
}

TEST_F(ASeatPanel, KeepsPersonFileAndViewsWithTheSettingsOfRviz) {
  find<QLineEdit>(panel_, "person")->setText("Jörg");
  find<QLineEdit>(panel_, "pose_file")->setText("/tmp/tip.csv");
  pages()->setCurrentIndex(static_cast<int>(Page::kFit));
  live_->setEnabled(true);  // a person wants both
  rviz::Config config;
  panel_.save(config);
  live_->setEnabled(false);
  SeatPanel other;
  other.load(config);
  other.initialize(&view_->manager);
  EXPECT_EQ(find<QLineEdit>(other, "person")->text(), "Jörg");
  EXPECT_EQ(find<QLineEdit>(other, "pose_file")->text(), "/tmp/tip.csv");
  find<QTabWidget>(other, "pages")->setCurrentIndex(static_cast<int>(Page::kFit));
  EXPECT_TRUE(live_->isEnabled());
}

}  // namespace
}  // namespace scan_cell_rviz
