// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause

/// The program trigger on the real loopback wire.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>

#include <cstdio>
#include <regex>
#include <sstream>

#include "scan_cell_common/files/files.h"
#include "scan_cell_common/testing/child_process.h"
#include "test_circuit.h"

using namespace laser_trigger;  // NOLINT
using scan_cell_common::ChildProcess;

namespace {

constexpr int kRefused = 2;

struct Outcome {
  int code;
  std::string said;  //!< on both outputs
};

/// A program whose outputs are read; killed if a test leaves it running.
class Command {
 public:
  // The shell becomes the program, so its process id comes before all output of the program.
  explicit Command(const std::string& words)
      : pipe_(popen(("echo $$; exec " + words + " 2>&1").c_str(), "r")),
        process_(std::stoi(line())) {}
  ~Command() {
    if (pipe_ == nullptr) return;
    kill(process_, SIGKILL);
    pclose(pipe_);
  }
  Command(const Command&) = delete;
  Command& operator=(const Command&) = delete;

  int process() const { return process_; }

  std::string line() {
    std::string text;
    for (int c = std::fgetc(pipe_); c != EOF && c != '\n'; c = std::fgetc(pipe_))
      text += static_cast<char>(c);
    return text;
  }

  Outcome end() {
    std::string said;
    for (int c = std::fgetc(pipe_); c != EOF; c = std::fgetc(pipe_))
      said += static_cast<char>(c);
    const int status = pclose(pipe_);
    pipe_ = nullptr;
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), said};
  }

 private:
  FILE* pipe_;
  int process_;
};

class TriggerTool : public testing::Test {
 protected:
  TriggerTool() { circuit_.start(); }

  std::string command(const std::string& words) const {
    return std::string(TRIGGER) + " --port loopback --loopback-port " +
           std::to_string(circuit_.address().port) + " " + words;
  }
  Outcome run(const std::string& words) const { return Command(command(words)).end(); }

  std::unique_ptr<ChildProcess> start(const std::string& words) const {
    std::istringstream stream(command(words));
    std::vector<std::string> list;
    for (std::string word; stream >> word;)
      list.push_back(word);
    return std::make_unique<ChildProcess>(list, true);
  }

  bool becomes(std::uint8_t data) {
    return wait_for([this, data] { return circuit_.data() == data; });
  }
  /// All lasers that were on at any time, in the register's bits.
  std::uint8_t lit() const {
    std::uint8_t bits = 0;
    for (const TestCircuit::Write& write : circuit_.writes())
      bits = static_cast<std::uint8_t>(bits | (write.data & (kLaser0 | kLaser1)));
    return bits;
  }

  TestCircuit circuit_;
};

}  // namespace

TEST_F(TriggerTool, GivesSoManyPulsesAndLeavesTheLinesLow) {
  const Outcome result = run("pulses --rate 200 --count 20 --laser 1");
  EXPECT_EQ(result.code, 0) << result.said;
  EXPECT_NE(result.said.find("20 pulses in "), std::string::npos) << result.said;
  ASSERT_TRUE(becomes(0));
  EXPECT_EQ(circuit_.rising_edges().size(), 20u);
  EXPECT_EQ(lit(), kLaser1);
}

TEST_F(TriggerTool, GivesPulsesForSoLong) {
  const Outcome result = run("pulses --rate 50 --seconds 1");
  EXPECT_EQ(result.code, 0) << result.said;
  ASSERT_TRUE(becomes(0));
  const auto edges = circuit_.rising_edges();
  ASSERT_GE(edges.size(), 2u);
  EXPECT_LE(edges.size(), 50u);
  EXPECT_LT(edges.back() - edges.front(), 1'000'000'000);
  EXPECT_EQ(lit(), 0);
}

TEST_F(TriggerTool, LetsTheLasersTakeTurnsOnlyWhereItIsTold) {
  for (const bool alternate : {false, true}) {
    const std::size_t before = circuit_.writes().size();
    const Outcome result = run(std::string("pulses --rate 100 --count 9 --laser 0 1") +
                               (alternate ? " --alternate" : ""));
    EXPECT_EQ(result.code, 0) << result.said;
    ASSERT_TRUE(becomes(0));
    std::vector<int> at_pulses;
    const std::vector<TestCircuit::Write> writes = circuit_.writes();
    for (std::size_t i = before; i < writes.size(); ++i)
      if ((writes[i].data & kCameraPulse) != 0) at_pulses.push_back(writes[i].data >> 1);
    const std::vector<int> in_turn = {1, 2, 1, 2, 1, 2, 1, 2, 1};
    EXPECT_EQ(at_pulses, alternate ? in_turn : std::vector<int>(9, 3));
  }
}

TEST_F(TriggerTool, SwitchesOneLaserOnForSoLongWithoutPulses) {
  const Outcome result = run("laser 0 --seconds 0.5");
  EXPECT_EQ(result.code, 0) << result.said;
  ASSERT_TRUE(becomes(0));
  EXPECT_EQ(lit(), kLaser0);
  EXPECT_TRUE(circuit_.rising_edges().empty());
  std::int64_t on = 0;
  std::int64_t off = 0;
  for (const TestCircuit::Write& write : circuit_.writes()) {
    if (write.data == kLaser0 && on == 0) on = write.time;
    if (write.data == 0 && on != 0 && off == 0) off = write.time;
  }
  EXPECT_GT(off - on, 480'000'000);
}

TEST_F(TriggerTool, LasersGoOffAtEachSignal) {
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    const auto tool = start("laser 1 --seconds 300");
    ASSERT_TRUE(becomes(kLaser1));
    kill(tool->id(), number);
    EXPECT_EQ(tool->wait(), kRefused) << number;
    EXPECT_TRUE(becomes(0)) << number;
  }
}

TEST_F(TriggerTool, SaysThatASignalEndedIt) {
  Command tool(command("laser 0 --seconds 300"));
  ASSERT_TRUE(becomes(kLaser0));
  kill(tool.process(), SIGTERM);
  const Outcome result = tool.end();
  EXPECT_EQ(result.code, kRefused);
  EXPECT_NE(result.said.find("stopped by a signal"), std::string::npos) << result.said;
}

TEST_F(TriggerTool, LasersGoOffWhenItIsKilled) {
  for (const char* const words :
       {"laser 0 --seconds 300", "pulses --rate 100 --seconds 300 --laser 0"}) {
    const auto tool = start(words);
    ASSERT_TRUE(wait_for([this] { return (circuit_.data() & ~kCameraPulse) == kLaser0; }));
    kill(tool->id(), SIGKILL);
    EXPECT_EQ(tool->wait(), 128 + SIGKILL);
    EXPECT_TRUE(becomes(0)) << words;
  }
}

TEST_F(TriggerTool, LasersGoOffWhenItHangs) {
  const auto tool = start("laser 0 --seconds 300");
  ASSERT_TRUE(becomes(kLaser0));
  kill(tool->id(), SIGSTOP);
  EXPECT_TRUE(becomes(0));
  EXPECT_EQ(tool->wait(), 128 + SIGKILL);
}

TEST_F(TriggerTool, SaysThatNoCircuitListens) {
  circuit_.stop();
  const Outcome result = run("laser 0 --seconds 1");
  EXPECT_EQ(result.code, 1);
  EXPECT_NE(result.said.find("no trigger circuit listens"), std::string::npos) << result.said;
}

TEST_F(TriggerTool, RefusesWhatMakesNoSenseAndSwitchesNothingOn) {
  for (const char* const words : {"",
                                  "pulses",
                                  "pulses --count 5",
                                  "pulses --rate 10",
                                  "pulses --rate 10 --count 5 --seconds 1",
                                  "pulses --rate 0 --count 5",
                                  "pulses --rate 1e6 --count 5",
                                  "pulses --rate 0.01 --count 1",
                                  "pulses --rate 10 --seconds 301",
                                  "pulses --rate 10 --count 3001",
                                  "pulses --rate 10 --count -1",
                                  "pulses --rate 10 --count 5 --laser 2",
                                  "pulses --rate 10 --count 5 --alternate",
                                  "pulses --rate 10 --count 5 --laser 1 --alternate",
                                  "pulses --rate 900 --count 5 --laser 0 1 --alternate",
                                  "laser 0 --seconds 1 --alternate",
                                  "laser",
                                  "laser 0",
                                  "laser 2 --seconds 1",
                                  "laser 0 --seconds 0",
                                  "laser 0 --seconds -1",
                                  "laser 0 --seconds nan",
                                  "laser 0 --seconds 1e9",
                                  "laser 0 1 --seconds 1"}) {
    const Outcome result = run(words);
    EXPECT_NE(result.code, 0) << words;
    EXPECT_NE(result.said, "") << words;
  }
  EXPECT_EQ(lit(), 0);
  EXPECT_TRUE(circuit_.rising_edges().empty());
}

TEST_F(TriggerTool, PrintsWhatTheLinesDoAsItHappens) {
  const std::string port = std::to_string(circuit_.address().port);
  circuit_.stop();
  Command watch(command("watch"));
  EXPECT_EQ(watch.line(),
            "listening on 127.0.0.1:" + port + " as the trigger circuit; Ctrl-C ends it");
  const auto before = scan_cell_common::host_now();
  EXPECT_EQ(run("pulses --rate 20 --count 2 --laser 0 1").code, 0);
  const auto after = scan_cell_common::host_now();
  for (const char* const what :
       {"laser_0 on", "laser_1 on", "pulse 1", "pulse 2", "laser_0 off", "laser_1 off"}) {
    const std::string line = watch.line();
    EXPECT_EQ(line.substr(line.find("  ") + 2), what);
    const auto time = std::stold(line.substr(0, line.find(' ')));
    EXPECT_GE(time, 1e-9L * static_cast<long double>(before) - 1e-6L);
    EXPECT_LE(time, 1e-9L * static_cast<long double>(after) + 1e-6L);
  }
  kill(watch.process(), SIGINT);
  const Outcome result = watch.end();
  EXPECT_EQ(result.code, 0) << result.said;
  EXPECT_EQ(result.said, "2 pulses\n");
}

TEST_F(TriggerTool, SaysWhatItCannotWatch) {
  const Outcome parallel = Command(std::string(TRIGGER) + " watch").end();
  EXPECT_EQ(parallel.code, kRefused);
  EXPECT_NE(parallel.said.find("/laser_trigger/events"), std::string::npos) << parallel.said;
  const Outcome taken = run("watch --seconds 1");
  EXPECT_EQ(taken.code, 1);
  EXPECT_NE(taken.said.find("Address already in use"), std::string::npos) << taken.said;
}

TEST_F(TriggerTool, SaysInItsDocumentWhatItSays) {
  std::istringstream page(scan_cell_common::read_file(TRIGGER_DOCUMENT));
  const std::string prompt = "    $ rosrun laser_trigger trigger --port loopback ";
  std::vector<std::pair<std::string, std::string>> examples;  // words and their output
  for (std::string line; std::getline(page, line);) {
    if (line.compare(0, prompt.size(), prompt) == 0) {
      examples.emplace_back(line.substr(prompt.size()), "");
    } else if (!examples.empty() && line.compare(0, 4, "    ") == 0) {
      examples.back().second += line.substr(4) + "\n";
    } else if (!examples.empty()) {
      break;  // the first block is the one of these examples
    }
  }
  ASSERT_EQ(examples.size(), 4u);
  const auto without_numbers = [](const std::string& text) {
    const std::string calm =
        std::regex_replace(text, std::regex("trigger: pulses without.*\n"), "");
    return std::regex_replace(calm, std::regex("[0-9]+(\\.[0-9]+)?"), "N");
  };
  for (const auto& [words, said] : examples) {
    const Outcome result = run(words);
    EXPECT_EQ(result.code, 0) << words << ": " << result.said;
    EXPECT_EQ(without_numbers(result.said), without_numbers(said)) << words;
  }
}
