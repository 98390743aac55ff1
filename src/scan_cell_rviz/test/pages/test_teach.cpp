// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
// The teach page with a fake driver that records its messages.
#include <gtest/gtest.h>
#include <scan_cell_msgs/RecordPose.h>

#include <QApplication>
#include <QMouseEvent>
#include <QPushButton>
#include <QTabWidget>
#include <QTest>
#include <QThread>
#include <functional>
#include <memory>
#include <mutex>
#include <vector>

#include "pages/preparation/teach_page.h"

namespace scan_cell_rviz {
namespace {

using scan_cell_msgs::Jog;

constexpr int kPatience = 20000;  // [ms]
constexpr int kSilence = 400;     // [ms] eight messages of a held button

/// Receives what the driver would do.
class FakeDriver {
 public:
  std::vector<Jog> heard() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return heard_;
  }

  void say(bool moving, const std::string& message) {
    scan_cell_msgs::JogState state;
    state.moving = static_cast<unsigned char>(moving);
    state.message = message;
    state_.publish(state);
  }

  std::string file() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return file_;
  }

 private:
  bool record(scan_cell_msgs::RecordPose::Request& request,
              scan_cell_msgs::RecordPose::Response& response) {
    const std::lock_guard<std::mutex> lock(mutex_);
    file_ = request.file;
    response.success = static_cast<unsigned char>(request.file.front() == '/');
    response.message = "file 'poses.csv': give an absolute path";
    response.poses = 3;
    response.pose.header.frame_id = "base_link";
    response.pose.pose.position.x = 1.2345;
    return true;
  }

  mutable std::mutex mutex_;
  std::vector<Jog> heard_;
  std::string file_;
  ros::NodeHandle node_;
  ros::Subscriber jog_ = node_.subscribe<Jog>("/c4g_driver/jog", 100, [this](const auto& jog) {
    const std::lock_guard<std::mutex> lock(mutex_);
    heard_.push_back(*jog);
  });
  ros::Publisher state_ =
      node_.advertise<scan_cell_msgs::JogState>("/c4g_driver/jog_state", 10, true);
  ros::ServiceServer record_ =
      node_.advertiseService("/scan_cell/record_pose", &FakeDriver::record, this);
};

class ATeachPage : public testing::Test {
 protected:
  ATeachPage() {
    driver_ = std::make_unique<FakeDriver>();
    link_.start();
    pages_.addTab(page_, "teach");
    pages_.addTab(new QWidget, "other");
    page_->set_free(true);
    pages_.show();
    pages_.activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(&pages_));
    EXPECT_TRUE(comes([this] { return link_.has_driver(); }));
  }

  /// Serves the window until the condition holds.
  static bool comes(const std::function<bool()>& condition) {
    return QTest::qWaitFor(condition, kPatience);
  }

  QPushButton* button(const char* name) const { return page_->findChild<QPushButton*>(name); }
  std::string text(const char* label) const {
    return page_->findChild<QLabel*>(label)->text().toStdString();
  }
  void press(const char* name) const { QTest::mousePress(button(name), Qt::LeftButton); }
  /// Moves the pointer with its left button down.
  static void drag(QPushButton* button, const QPoint& to) {
    QMouseEvent move(QEvent::MouseMove, to, button->mapToGlobal(to), Qt::NoButton, Qt::LeftButton,
                     Qt::NoModifier);
    QApplication::sendEvent(button, &move);
  }
  void release(const char* name) const { QTest::mouseRelease(button(name), Qt::LeftButton); }

  std::size_t count() const { return driver_->heard().size(); }

  /// Whether the robot is commanded to move, repeatedly.
  bool goes() const {
    const std::size_t before = count();
    return comes([&] { return count() >= before + 3 && driver_->heard().back().direction != 0; });
  }

  /// Whether the robot is commanded to stop, and nothing follows.
  bool has_stopped() const {
    if (!comes([this] { return count() > 0 && driver_->heard().back().direction == 0; }))
      return false;
    const std::size_t before = count();
    QTest::qWait(kSilence);
    return count() == before;
  }

  std::unique_ptr<FakeDriver> driver_;
  TeachLink link_{NodeNames()};
  QTabWidget pages_;
  TeachPage* page_ = new TeachPage(link_);
};

TEST_F(ATeachPage, MovesTheRobotWhileAButtonIsHeld) {
  page_->findChild<QComboBox*>("jog_kind")->setCurrentIndex(Jog::BASE);
  page_->findChild<QDoubleSpinBox*>("jog_speed")->setValue(7);
  press("jog_minus_3");
  ASSERT_TRUE(goes());
  const auto heard = driver_->heard();
  for (std::size_t i = 1; i < heard.size(); ++i) {  // after the message with the released button
    const Jog& jog = heard[i];
    EXPECT_EQ(jog.kind, Jog::BASE);
    EXPECT_EQ(jog.axis, 2);
    EXPECT_EQ(jog.direction, -1);
    EXPECT_EQ(jog.override, 7);
  }
  release("jog_minus_3");
  EXPECT_TRUE(has_stopped());
}

TEST_F(ATeachPage, MovesTheRobotWhileTheSpaceBarIsHeld) {
  QPushButton* const plus = button("jog_plus_5");
  plus->setFocus();
  QTest::keyPress(plus, Qt::Key_Space);
  ASSERT_TRUE(goes());
  for (const auto type : {QEvent::KeyRelease, QEvent::KeyPress}) {  // of the keyboard's auto-repeat
    QKeyEvent repeated(type, Qt::Key_Space, Qt::NoModifier, " ", true);
    QApplication::sendEvent(plus, &repeated);
  }
  ASSERT_TRUE(goes());
  const auto heard = driver_->heard();
  for (std::size_t i = 1; i < heard.size(); ++i)
    EXPECT_EQ(heard[i].direction, 1) << "it stopped in between";
  QTest::keyRelease(plus, Qt::Key_Space);
  EXPECT_TRUE(has_stopped());
}

TEST_F(ATeachPage, StopsTheRobotWhateverTakesTheButtonAway) {
  QEvent deactivated(QEvent::WindowDeactivate);
  const std::pair<const char*, std::function<void()>> causes[] = {
      {"another widget gets the focus", [this] { page_->findChild<QLineEdit*>()->setFocus(); }},
      {"another page is shown", [this] { pages_.setCurrentIndex(1); }},
      {"the cell begins something", [this] { page_->set_free(false); }},
      {"another window is active", [&] { QApplication::sendEvent(&pages_, &deactivated); }},
      {"the window is hidden", [this] { pages_.hide(); }},
      {"other axes are chosen",
       [this] { page_->findChild<QComboBox*>("jog_kind")->setCurrentIndex(Jog::FLANGE); }},
  };
  for (const auto& [name, cause] : causes) {
    pages_.show();
    pages_.setCurrentIndex(0);
    page_->set_free(true);
    press("jog_plus_1");
    ASSERT_TRUE(goes()) << name;
    cause();
    EXPECT_TRUE(has_stopped()) << name;
    EXPECT_FALSE(button("jog_plus_1")->isDown()) << name;
    release("jog_plus_1");
  }
}

TEST_F(ATeachPage, StopsWhereThePointerLeavesTheButtonAndDoesNotGoOnWhereItComesBack) {
  QPushButton* const plus = button("jog_plus_1");
  press("jog_plus_1");
  ASSERT_TRUE(goes());
  drag(plus, plus->rect().bottomRight() + QPoint(50, 50));
  EXPECT_TRUE(has_stopped());
  drag(plus, plus->rect().center());
  EXPECT_TRUE(has_stopped());
  release("jog_plus_1");
  press("jog_plus_1");
  EXPECT_TRUE(goes());
  release("jog_plus_1");
}

TEST_F(ATeachPage, TellsThatTheButtonWasUpWheneverItIsPressed) {
  press("jog_plus_1");
  ASSERT_TRUE(goes());
  EXPECT_EQ(driver_->heard().front().direction, 0);
  release("jog_plus_1");
}

TEST_F(ATeachPage, MustBePressedAnewWhereTheWindowHung) {
  press("jog_plus_1");
  ASSERT_TRUE(goes());
  const std::size_t before = count();
  QThread::msleep(kSilence);  // the window hangs, whatever the person does
  EXPECT_LE(count(), before + 1) << "something else than the window moves the robot";
  EXPECT_TRUE(has_stopped());
  EXPECT_LE(count(), before + 2);
  EXPECT_NE(text("jog_said").find("press the button again"), std::string::npos);
  drag(button("jog_plus_1"), button("jog_plus_1")->rect().center() + QPoint(1, 0));
  EXPECT_TRUE(has_stopped()) << "the mouse, still held, moved";
  release("jog_plus_1");
  press("jog_plus_1");
  EXPECT_TRUE(goes());
  release("jog_plus_1");
}

TEST_F(ATeachPage, MustBePressedAnewWhereTheDriverWasGone) {
  press("jog_plus_1");
  ASSERT_TRUE(goes());
  ros::NodeHandle node;
  const boost::function<void(const scan_cell_msgs::JogConstPtr&)> listen = [](const auto&) {};
  const ros::Subscriber recording = node.subscribe<Jog>("/c4g_driver/jog", 10, listen);
  driver_.reset();
  EXPECT_TRUE(comes([this] { return !button("jog_plus_1")->isDown(); }));
  EXPECT_NE(text("jog_said").find("not running"), std::string::npos) << text("jog_said");
  driver_ = std::make_unique<FakeDriver>();
  ASSERT_TRUE(comes([this] { return link_.has_driver(); }));
  QTest::qWait(kSilence);
  EXPECT_EQ(count(), 0u) << "it goes on by itself";
  release("jog_plus_1");
  press("jog_plus_1");
  EXPECT_TRUE(goes());
  release("jog_plus_1");
}

TEST_F(ATeachPage, ShowsWhyTheRobotDoesNotMoveAndWhereItsJointsAre) {
  driver_->say(false, "J5 is at the end of its range");
  EXPECT_TRUE(comes([this] { return text("jog_said") == "J5 is at the end of its range"; }));
  driver_->say(true, "");
  EXPECT_TRUE(comes([this] { return text("jog_said") == "The robot moves."; }));
  driver_->say(false, "");
  EXPECT_TRUE(comes([this] { return text("jog_said").empty(); }));
  ros::NodeHandle node;
  ros::Publisher joints = node.advertise<sensor_msgs::JointState>("/joint_states", 1, true);
  sensor_msgs::JointState state;
  state.position = {0, 0.5, -1, 0, 0, 3};
  joints.publish(state);
  EXPECT_TRUE(comes([this] { return text("joint_2") == "28.65\u00b0"; })) << text("joint_2");
  EXPECT_EQ(text("joint_6"), "171.89\u00b0");
}

TEST_F(ATeachPage, TakesThePoseAndSaysWhatItWasOrWhyNot) {
  page_->set_file("/tmp/poses.csv");
  QTest::mouseClick(button("take_pose"), Qt::LeftButton);
  EXPECT_TRUE(comes([this] { return !text("pose_taken").empty(); }));
  EXPECT_EQ(text("pose_taken"), "Pose 3 of /tmp/poses.csv: 1234.50, 0.00, 0.00 mm in base_link");
  EXPECT_EQ(driver_->file(), "/tmp/poses.csv");
  page_->set_file("poses.csv");
  QTest::mouseClick(button("take_pose"), Qt::LeftButton);
  EXPECT_TRUE(comes([this] {
    return text("pose_taken").find("give an absolute path") != std::string::npos;
  })) << text("pose_taken");
}

}  // namespace
}  // namespace scan_cell_rviz

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  qputenv("QT_QPA_PLATFORM", "offscreen");
  ros::init(argc, argv, "test_teach");
  ros::AsyncSpinner spinner(2);
  spinner.start();
  const QApplication application(argc, argv);
  return RUN_ALL_TESTS();
}
