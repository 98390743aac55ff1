// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause

/// The program c4g against controllers on real sockets: the emulator, and one that is scripted.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <mutex>
#include <sstream>

#include "link/client_test.h"
#include "scan_cell_common/testing/child_process.h"
#include "scan_cell_sim/controller/controller.h"

using nlohmann::json;

namespace {

struct Result {
  int code;
  std::string said;  //!< on both outputs
};

Result run(const std::string& command) {
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  std::string said;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe))
    said += static_cast<char>(c);
  const int status = pclose(pipe);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), said};
}

/// A command line for the controller at a port of this machine.
std::string command_line(std::uint16_t port, const std::string& words) {
  return std::string(C4G) + " --address 127.0.0.1 --port " + std::to_string(port) +
         " --urdf " URDF_FILE " " + words;
}

class C4gTool : public testing::Test {
 protected:
  C4gTool() {
    scan_cell_sim::ControllerOptions options;
    options.port = 0;
    options.witness = [this](const scan_cell_sim::TakenUp& taken) {
      const std::lock_guard<std::mutex> lock(mutex_);
      requests_.push_back(json::parse(taken.datagram));
    };
    controller_ = std::make_unique<scan_cell_sim::Controller>(options);
  }

  Result c4g(const std::string& words) const {
    return run(command_line(controller_->port(), words));
  }

  /// Expects success and this output.
  void expect(const std::string& words, const std::string& said) const {
    const Result result = c4g(words);
    EXPECT_EQ(result.code, 0) << words << ": " << result.said;
    EXPECT_NE(result.said.find(said), std::string::npos) << words << ": " << result.said;
  }

  /// Expects a refusal with this reason, and no motion.
  void expect_refusal(const std::string& words, const std::string& reason) const {
    const Result result = c4g(words);
    EXPECT_EQ(result.code, 2) << words << ": " << result.said;
    EXPECT_NE(result.said.find(reason), std::string::npos) << words << ": " << result.said;
    EXPECT_EQ(controller_->motions_begun(), 0u) << words;
  }

  /// The commands accepted, except polls.
  std::vector<std::string> commands() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::vector<std::string> result;
    for (const json& request : requests_) {
      if (request["cmd"] != "GET_STATIC_POSE") result.push_back(request["cmd"].get<std::string>());
    }
    return result;
  }

  json latest(const std::string& command) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = std::find_if(requests_.rbegin(), requests_.rend(),
                                    [&](const json& request) { return request["cmd"] == command; });
    return found == requests_.rend() ? json() : *found;
  }

  double off(const Eigen::Isometry3d& place) const {
    return c4g_driver::twist(controller_->state().flange, place).norm();
  }

  mutable std::mutex mutex_;
  std::vector<json> requests_;
  std::unique_ptr<scan_cell_sim::Controller> controller_;
};

constexpr double kHere = 1e-5;  // [m, rad]

}  // namespace

TEST_F(C4gTool, SaysWhereTheRobotIsAndHowItIs) {
  const Result result = c4g("status");
  EXPECT_EQ(result.code, 0) << result.said;
  for (const char* line :
       {"mode            remote", "emergency stop  released", "drives          on",
        "takes motions   yes", "latest motion   idle", "override        100 %",
        "linear speed    250 mm/s", "alarms          none",
        "pose            800.000 0.000 600.000 0.0000 180.0000 180.0000",
        "joints          0.0000 8.158"})
    EXPECT_NE(result.said.find(line), std::string::npos) << line << " in\n" << result.said;
  EXPECT_EQ(commands().back(), "CLOSE");
  controller_->press_e_stop();
  const Result stopped = c4g("status");
  for (const char* line : {"emergency stop  pressed", "drives          off", "takes motions   no",
                           "alarm           11 emergency stop"})
    EXPECT_NE(stopped.said.find(line), std::string::npos) << line << " in\n" << stopped.said;
}

TEST_F(C4gTool, MovesAlongAnArc) {
  expect("move circular --camera-rate 50 850 50 600 0 180 180 800 100 600 0 180 90",
         "reached         800.000 100.000 600.000 0.0000 180.0000 90.0000");
  EXPECT_EQ(latest("MOVE_CIRCULAR")["via"][0], 850);
  EXPECT_EQ(latest("MOVE_CIRCULAR")["camera_fps"], 50);
  EXPECT_EQ(controller_->motions_begun(), 1u);
}

TEST_F(C4gTool, MovesAlongALineAndInJoints) {
  expect("move cartesian 800 -50 620 0 180 180", "reached         800.000 -50.000 620.000");
  EXPECT_LT(off(looking_down(0.80, -0.05, 0.62)), kHere);
  expect("move cartesian 800 -50 620 90 180 -90", "reached");
  EXPECT_LT(off(looking_down(0.80, -0.05, 0.62)), kHere) << "the same orientation";
  expect("write override 5", "5");
  expect("move --camera-rate 50 joint 3 8 -124 -2 48 5", "reached");
  EXPECT_LT(off(smart5_six().flange_at(degrees(3, 8, -124, -2, 48, 5))), kHere);
  EXPECT_EQ(controller_->motions_begun(), 3u);
  EXPECT_EQ(latest("MOVE_JOINT")["camera_fps"], 50);
}

TEST_F(C4gTool, StopsTheRobotAndClosesTheSessionAtEachSignalThatEndsIt) {
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    signal(number, SIG_DFL);  // under nohup the tests, and so the tool, would ignore it
    const std::uint64_t before = controller_->motions_begun();
    std::istringstream words(command_line(
        controller_->port(), number == SIGTERM ? "move cartesian 800 -300 600 0 180 180"
                                               : "move cartesian 800 300 600 0 180 180"));
    std::vector<std::string> command;
    for (std::string word; words >> word;)
      command.push_back(word);
    scan_cell_common::ChildProcess tool(command, true);
    const auto moving = [&] {
      const auto state = controller_->state();
      return controller_->motions_begun() > before && state.progress > 0.02;
    };
    ASSERT_TRUE(c4g_driver::eventually(moving)) << number;
    kill(tool.id(), number);
    EXPECT_EQ(tool.wait(), 2) << number;
    const auto seen = commands();
    ASSERT_GE(seen.size(), 3u);
    EXPECT_EQ(seen[seen.size() - 3].substr(0, 4), "MOVE") << number;
    EXPECT_EQ(seen[seen.size() - 2], "STOP") << number;
    EXPECT_EQ(seen[seen.size() - 1], "CLOSE") << number;
    EXPECT_NE(controller_->state().status, scan_cell_sim::MotionStatus::kMoving);
    EXPECT_LT(std::abs(controller_->state().flange.translation().y()), 0.29) << number;
  }
}

TEST_F(C4gTool, RefusesWhatTheDriverRefusesBeforeAnythingIsSent) {
  expect_refusal("move cartesian 800 0 100 0 180 180", "target z: 0.1 m");
  expect_refusal("move cartesian 1390 0 1700 0 180 180", "out of reach");
  expect_refusal("move cartesian 800 0 nan 0 180 180", "target z: nan m");
  expect_refusal("move cartesian 800 0 610 400 180 180", "target A: 400");
  expect_refusal("move cartesian 800 0 610 0 190 180", "target E: 190");
  expect_refusal("move circular 800 50 600 0 180 180 800 100 600 0 180 180", "via: only ");
  expect_refusal("move circular 850 50 600 0 190 180 800 100 600 0 180 180", "via E: 190 deg");
  expect_refusal("move circular 850 50 600 0 180 180 800 100 600 0 190 180", "target E: 190 deg");
  expect_refusal("move joint 0 8 5 0 48 0", "target J3");
  expect_refusal("move joint 60 8 -124 0 48 0", "speed of the flange");
  expect_refusal("--workspace-max 900 100 900 move cartesian 800 200 600 0 180 180", "target y");
  expect_refusal("--joint-upper 10 10 0 10 60 10 move joint 11 8 -124 0 48 0", "target J1");
  expect_refusal("write linear_speed 251", "linear speed: 0.251 m/s");
  expect_refusal("write override 0", "override: 0 %");
  expect_refusal("move cartesian --camera-rate -1 800 0 610 0 180 180", "camera rate: -1 Hz");
  expect("--operation automatic write linear_speed 400", "400");
  expect_refusal("move cartesian 800 20 600 0 180 180", "linear speed set on the controller");
  EXPECT_EQ(c4g("--workspace-min 0 0 2000 status").code, 1) << "no box";
}

TEST_F(C4gTool, SwitchesDrivesResetsAlarmsAndStops) {
  expect("drives off", "drives off");
  EXPECT_FALSE(controller_->state().readiness.drives());
  expect_refusal("move cartesian 800 20 600 0 180 180", "drives");
  expect("drives on", "drives on");
  EXPECT_TRUE(controller_->state().readiness.drives());
  expect("alarms", "no alarms");
  controller_->press_e_stop();
  expect("alarms", "11 emergency stop");
  EXPECT_EQ(c4g("alarms --reset").code, 2) << "the button is pressed";
  controller_->release_e_stop();
  expect("alarms --reset", "no alarms");
  expect("stop", "stands at       800.000 0.000 600.000");
  EXPECT_EQ(commands().at(commands().size() - 2), "STOP");
}

TEST_F(C4gTool, ReadsAndWritesParameters) {
  expect("read motion_type", "\"linear\"\n");
  expect("write motion_type joint", "\"joint\"\n");
  expect("write motion_type '\"linear\"'", "\"linear\"\n");
  expect("write user_frame '[500, 0, 100, 0, 0, 90]'", "[500");
  expect("write rotational_speed 30", "30");
  EXPECT_EQ(c4g("write motion_type sideways").code, 2);
  EXPECT_EQ(c4g("read no_such_parameter").code, 2);
  EXPECT_EQ(c4g("write user_frame [500,").code, 2) << "no JSON";
}

TEST_F(C4gTool, SaysWhyThereIsNoConnection) {
  c4g_driver::ClientOptions options;
  options.port = controller_->port();
  options.robot = std::make_shared<c4g_driver::RobotModel>(smart5_six());
  const c4g_driver::Client other(options, nullptr);
  ASSERT_TRUE(other.wait_for_link(10));
  const Result busy = c4g("--timeout 0.3 stop");
  EXPECT_EQ(busy.code, 1);
  EXPECT_NE(busy.said.find("another client has the controller"), std::string::npos) << busy.said;
  const Result dead = run(command_line(9, "--timeout 0.3 status"));
  EXPECT_EQ(dead.code, 1);
  EXPECT_NE(dead.said.find("controller 127.0.0.1:9: no answer yet"), std::string::npos)
      << dead.said;
}

TEST_F(C4gTool, TakesNoHalfCommand) {
  for (const char* words : {"", "move", "move cartesian 1 2 3", "move cartesian 1 2 3 4 5 6 7",
                            "move circular 1 2 3 4 5 6", "move joint a b c d e f", "drives",
                            "drives maybe", "read", "write motion_type", "status --nonsense"})
    EXPECT_EQ(c4g(words).code, 1) << words;
  const Result old = c4g("--most-linear-speed 100 status");
  EXPECT_EQ(old.code, 1);
  EXPECT_EQ(old.said, "c4g: --most-linear-speed: renamed; use --max-linear-speed\n");
  EXPECT_EQ(c4g("--help").code, 0);
  EXPECT_TRUE(commands().empty());
}

TEST(C4gToolAndALawlessController, ShowsNothingThatCommandsTheTerminal) {
  FakeController controller;
  controller.set_state(
      {{"alarms", {{{"code", 15}, {"text", "one\n\x1b[2Jtwo"}}}}, {"e_stop", true}});
  for (const char* command : {"status", "alarms"}) {
    const Result result = run(command_line(controller.port(), command));
    EXPECT_EQ(result.code, 0);
    EXPECT_NE(result.said.find("15 one??[2Jtwo\n"), std::string::npos) << result.said;
  }
}

TEST(C4gToolAndALawlessController, MovesNothingUnderASettingThatTheProtocolDoesNotKnow) {
  FakeController controller;
  controller.play([&controller](const json& request) -> std::optional<std::vector<json>> {
    if (request.value("name", "") != "motion_type") return std::nullopt;
    json answer = controller.acknowledge(request);
    answer["value"] = "circular";
    return std::vector<json>{answer};
  });
  const Result result = run(command_line(controller.port(), "move cartesian 800 20 600 0 180 180"));
  EXPECT_NE(result.code, 0);
  EXPECT_NE(result.said.find("motion_type of the controller: \"circular\""), std::string::npos)
      << result.said;
  EXPECT_TRUE(controller.requests("MOVE_CARTESIAN").empty());
}
