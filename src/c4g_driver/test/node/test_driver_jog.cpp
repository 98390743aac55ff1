// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <scan_cell_msgs/Jog.h>
#include <scan_cell_msgs/JogState.h>

#include <thread>

#include "node/driver_node_test.h"

using driver_node_test::eventually;
using driver_node_test::Latest;
using driver_node_test::looking_down;
using scan_cell_msgs::Jog;
using scan_cell_msgs::JogState;

namespace {

/// A person at a button.
class JoggedDriver : public driver_node_test::Driver {
 protected:
  void SetUp() override {
    Driver::SetUp();
    ASSERT_TRUE(eventually([this] { return jog_.getNumSubscribers() > 0; }));
    begin_ = truth();
  }

  Jog along(std::uint8_t kind, std::uint8_t axis, std::int8_t direction) const {
    Jog jog;
    jog.kind = kind;
    jog.axis = axis;
    jog.direction = direction;
    jog.override = 10;
    return jog;
  }

  /// Presses the button and holds it until the condition holds.
  bool press(const Jog& jog, const std::function<bool()>& condition) {
    let_go();
    return hold(jog, condition);
  }

  /// Sends what a held button sends until the condition holds.
  bool hold(const Jog& jog, const std::function<bool()>& condition) {
    return eventually([&] {
      jog_.publish(jog);
      ros::WallDuration(0.02).sleep();
      return condition();
    });
  }

  void let_go() { jog_.publish(Jog()); }

  double moved() const { return driver_node_test::distance(truth(), begin_); }

  bool stands() const {
    return controller_->state().status != scan_cell_sim::MotionStatus::kMoving;
  }

  std::string said() const {
    const auto all = state_.all();
    return all.empty() ? "" : all.back().message;
  }

  ros::NodeHandle jog_node_;
  ros::Publisher jog_ = jog_node_.advertise<Jog>("/c4g_driver/jog", 10);
  Latest<JogState> state_{jog_node_, "/c4g_driver/jog_state"};
  Eigen::Isometry3d begin_;
};

}  // namespace

TEST_F(JoggedDriver, MovesWhileTheButtonIsHeldAndStopsWhenItIsLetGo) {
  ASSERT_TRUE(press(along(Jog::BASE, 1, 1), [this] { return moved() > 0.01; })) << said();
  EXPECT_NEAR(truth().translation().x(), begin_.translation().x(), 1e-3);
  EXPECT_GT(truth().translation().y(), begin_.translation().y());
  let_go();
  ASSERT_TRUE(eventually([this] { return stands(); }, 0.5));
  const double stopped = moved();
  EXPECT_LT(stopped, 0.1);
  EXPECT_FALSE(eventually([&] { return moved() > stopped + 1e-6; }, 0.5)) << "it goes on";
  EXPECT_TRUE(
      eventually([this] { return state_.is([](const auto& s) { return s.moving == 0; }); }));
}

TEST_F(JoggedDriver, StopsWhereNobodyHoldsTheButtonAnyLonger) {
  ASSERT_TRUE(press(along(Jog::FLANGE, 2, -1), [this] { return moved() > 0.01; })) << said();
  EXPECT_TRUE(eventually([this] { return stands(); }, 0.7));  // silence, a check, braking
}

TEST_F(JoggedDriver, TurnsRoundWithoutLettingGo) {
  ASSERT_TRUE(press(along(Jog::BASE, 1, 1), [this] { return moved() > 0.01; })) << said();
  EXPECT_TRUE(hold(along(Jog::BASE, 1, -1), [this] {
    return truth().translation().y() < begin_.translation().y() - 0.005;
  })) << said();
  let_go();
}

TEST_F(JoggedDriver, MovesOneJointToTheEndOfItsRangeAndNotBeyond) {
  const double range = scan_cell_sim::joint_limits().upper[4];
  const double begin = controller_->state().joints[4];
  ASSERT_TRUE(press(along(Jog::JOINT, 4, 1), [&] {
    return controller_->state().joints[4] > begin + 0.1;
  })) << said();
  ASSERT_TRUE(hold(along(Jog::JOINT, 4, 1), [&] { return !said().empty() && stands(); }));
  EXPECT_LT(controller_->state().joints[4], range + 1e-6);
  EXPECT_GT(controller_->state().joints[4], range - 0.02);
  EXPECT_NE(said().find("J5"), std::string::npos) << said();
}

TEST_F(JoggedDriver, DoesNotGoOnByItselfAfterAnEmergencyStop) {
  ASSERT_TRUE(press(along(Jog::BASE, 1, 1), [this] { return moved() > 0.01; })) << said();
  controller_->press_e_stop();
  ASSERT_TRUE(hold(along(Jog::BASE, 1, 1), [this] { return stands() && !said().empty(); }));
  controller_->release_e_stop();
  const double stopped = moved();
  EXPECT_FALSE(eventually(
      [&] {
        jog_.publish(along(Jog::BASE, 1, 1));
        return moved() > stopped + 1e-6;
      },
      1));
}

TEST_F(JoggedDriver, RestoresTheSpeedThatWasSet) {
  const auto is = [this](double percent) {
    return eventually(
        [&] { return status_.is([&](const auto& status) { return status.override == percent; }); });
  };
  ASSERT_TRUE(is(100));
  ASSERT_TRUE(press(along(Jog::BASE, 1, 1), [this] { return moved() > 0.005; })) << said();
  EXPECT_TRUE(is(10));
  let_go();
  EXPECT_TRUE(is(100));
}

TEST_F(JoggedDriver, LeavesTheMotionOfOthersAlone) {
  start_long_move();
  ASSERT_TRUE(press(along(Jog::BASE, 0, 1), [this] { return !said().empty(); }));
  EXPECT_NE(said().find("another is under way"), std::string::npos) << said();
  ASSERT_TRUE(move_.waitForResult(driver_node_test::kPatience));
  EXPECT_EQ(move_.getResult()->outcome, driver_node_test::MoveResult::REACHED);
}

TEST_F(JoggedDriver, RefusesASpeedOrAnAxisThatIsNone) {
  Jog fast = along(Jog::BASE, 1, 1);
  fast.override = 50;
  ASSERT_TRUE(press(fast, [this] { return said().find("max_jog_override") != std::string::npos; }));
  Jog axis = along(Jog::JOINT, 6, 1);
  ASSERT_TRUE(hold(axis, [this] { return said().find("axis") != std::string::npos; }));
  EXPECT_LT(moved(), 1e-9);
}

TEST_F(JoggedDriver, DoesNotBeginWithAButtonThatWasHeldBeforeItHeardOfIt) {
  const auto moves = [this] { return moved() > 1e-6; };
  const auto held_for_a_second = [&] {
    return eventually(
        [&] {
          jog_.publish(along(Jog::BASE, 1, 1));
          ros::WallDuration(0.02).sleep();
          return moves();
        },
        1);
  };
  EXPECT_FALSE(held_for_a_second()) << "the driver was started while it was held";
  ASSERT_TRUE(press(along(Jog::BASE, 1, 1), [this] { return moved() > 0.01; })) << said();
  ASSERT_TRUE(eventually([this] { return stands(); }, 0.7)) << "nothing comes";
  begin_ = truth();
  EXPECT_FALSE(held_for_a_second()) << "the network was gone while it was held";
}
