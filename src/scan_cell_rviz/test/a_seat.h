// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <QTest>
#include <functional>
#include <memory>
#include <string>

#include "fake_recipes.h"
#include "seat/seat.h"

namespace scan_cell_rviz {

constexpr int kPatience = 20000;  // [ms]

/// The seat with a fake node of recipes.
class ASeat : public testing::Test {
 protected:
  ASeat() {
    recipes_ = std::make_unique<FakeRecipes>();
    links_.start();
    seat_.show();
    EXPECT_TRUE(comes([this] { return recipe_list()->count() == 2; })) << text("missed");
    EXPECT_TRUE(comes([this] { return link_.busy() == Busy::kFree; }));
  }

  /// Serves the window until it is so.
  static bool comes(const std::function<bool()>& condition) {
    return QTest::qWaitFor(condition, kPatience);
  }

  template <class Widget>
  Widget* find(const char* name) const {
    Widget* const widget = seat_.findChild<Widget*>(name);
    EXPECT_NE(widget, nullptr) << name;
    return widget;
  }

  QPushButton* button(const char* name) const { return find<QPushButton>(name); }
  QListWidget* recipe_list() const { return find<QListWidget>("recipes"); }
  std::string text(const char* label) const { return find<QLabel>(label)->text().toStdString(); }
  std::string trouble() const { return text("trouble"); }
  void click(const char* name) const { QTest::mouseClick(button(name), Qt::LeftButton); }

  void choose_frame() const { recipe_list()->setCurrentRow(0); }

  /// Clicks until the goal has come: the server may not be connected yet.
  void scan() {
    choose_frame();
    const int before = recipes_->goals();
    EXPECT_TRUE(comes([&] {
      if (link_.busy() == Busy::kFree && button("run")->isEnabled()) click("run");
      QTest::qWait(50);
      return recipes_->goals() > before;
    })) << trouble();
  }

  /// A part that was scanned and whose verdict is in view.
  void scan_to(std::uint8_t outcome) {
    scan();
    recipes_->finish(outcome);
    EXPECT_TRUE(comes([this] { return !text("verdict").empty(); })) << trouble();
  }

  std::unique_ptr<FakeRecipes> recipes_;
  SeatLinks links_{NodeNames()};
  CellLink& link_ = links_.cell;
  EditSession edits_;
  PathSession path_;
  PickSession picks_;
  PassSession passes_;
  Seat seat_{links_, {edits_, path_, picks_, passes_}};
};

}  // namespace scan_cell_rviz
