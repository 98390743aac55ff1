// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
// What happens to the lasers when the process that switched them on dies or hangs.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include <fstream>
#include <functional>

#include "laser_trigger/guardian.h"
#include "laser_trigger/pulse_generator.h"
#include "parallel_port.h"
#include "test_circuit.h"

using namespace laser_trigger;  // NOLINT

namespace {

constexpr std::uint8_t kLasers = kLaser0 | kLaser1;

/// What a child process does with its pulse generator; the result is the child's exit code.
using Life = std::function<int(PulseGenerator&)>;

/// @param circuit only its address is used
int start_child(TestCircuit& circuit, double hang_timeout, const Life& life) {
  const int child = fork();
  if (child < 0) throw std::runtime_error("no process to be had");
  if (child > 0) return child;
  const PortAddress address = circuit.address();
  circuit.stop();  // closes its copy of the socket, which would keep a stopped circuit reachable
  Guardian guardian;
  guardian.watch(address, hang_timeout);
  const auto port = open_port(address);
  PulseGenerator::Settings settings;
  settings.keep_alive_timeout = 1000;
  PulseGenerator generator(*port, &guardian, settings, {[](const Pulse&) {}, [] {}});
  _exit(life(generator));
}

int pulse_for_ever(PulseGenerator& generator) {
  generator.arm({100, 3, 0});
  while (true)
    pause();
}

int alternate_for_ever(PulseGenerator& generator) {
  generator.arm({100, 3, 0, true, true});
  while (true)
    pause();
}

int crash(PulseGenerator& generator) {
  generator.arm({100, 3, 0});
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  abort();
}

constexpr double kHangTimeout = 0.5;  // [s]
constexpr int kOutlived = 42;

int outlive_the_hang_timeout() {
  std::this_thread::sleep_for(std::chrono::duration<double>(4 * kHangTimeout));
  return kOutlived;
}

class GuardianTest : public testing::Test {
 protected:
  void start(double hang_timeout, const Life& life) {
    child_ = start_child(circuit_, hang_timeout, life);
    circuit_.start();
  }
  bool lasers_are_on() {
    return wait_for([this] { return circuit_.rising_edges().size() >= 3; });
  }
  bool lines_go_low() {
    return wait_for([this] { return circuit_.data() == 0; });
  }
  /// Waits for the child's end.
  /// @return its exit code, or the negative number of the signal that killed it
  int end_of_child() {
    int status = 0;
    EXPECT_EQ(waitpid(child_, &status, 0), child_);
    child_ = -1;
    return WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status);
  }
  void TearDown() override {
    if (child_ <= 0) return;  // kill(-1) would mean every process
    kill(child_, SIGKILL);
    waitpid(child_, nullptr, 0);
  }

  TestCircuit circuit_;
  int child_ = -1;
};

}  // namespace

TEST_F(GuardianTest, LasersGoOffWhenTheProcessIsKilled) {
  start(60, pulse_for_ever);
  ASSERT_TRUE(lasers_are_on());
  kill(child_, SIGKILL);
  EXPECT_TRUE(lines_go_low());
}

TEST_F(GuardianTest, LasersGoOffWhenTheProcessCrashes) {
  start(60, crash);
  ASSERT_TRUE(wait_for([this] { return circuit_.writes().size() > 1; }));
  EXPECT_TRUE(lines_go_low());
}

TEST_F(GuardianTest, LasersGoOffWhenTheProcessHangs) {
  start(kHangTimeout, pulse_for_ever);
  ASSERT_TRUE(lasers_are_on());
  kill(child_, SIGSTOP);
  EXPECT_TRUE(lines_go_low());
  EXPECT_EQ(end_of_child(), -SIGKILL);
}

TEST_F(GuardianTest, LasersThatAlternateGoOffWhenTheProcessIsKilled) {
  start(60, alternate_for_ever);
  ASSERT_TRUE(lasers_are_on());
  kill(child_, SIGKILL);
  EXPECT_TRUE(lines_go_low());
  EXPECT_EQ(end_of_child(), -SIGKILL);
  for (const TestCircuit::Write& write : circuit_.writes())
    EXPECT_NE(write.data & kLasers, kLasers);
}

TEST_F(GuardianTest, LasersThatAlternateGoOffWhenTheProcessHangs) {
  start(kHangTimeout, alternate_for_ever);
  ASSERT_TRUE(lasers_are_on());
  kill(child_, SIGSTOP);
  EXPECT_TRUE(lines_go_low());
  EXPECT_EQ(end_of_child(), -SIGKILL);
}

TEST_F(GuardianTest, SparesAProcessThatDisarmsBecauseTheCircuitIsLost) {
  start(kHangTimeout, [](PulseGenerator& generator) {
    generator.arm({100, 3, 0});
    const bool disarmed = wait_for([&] { return !generator.status().armed; });
    return disarmed ? outlive_the_hang_timeout() : 1;
  });
  ASSERT_TRUE(lasers_are_on());
  circuit_.stop();
  EXPECT_EQ(end_of_child(), kOutlived);
}

TEST_F(GuardianTest, SparesAProcessThatCannotArmForWantOfACircuit) {
  circuit_.stop();
  child_ = start_child(circuit_, kHangTimeout, [](PulseGenerator& generator) {
    try {
      generator.arm({100, 3, 0});
      return 1;
    } catch (const NoDevice&) {
      return outlive_the_hang_timeout();
    }
  });
  EXPECT_EQ(end_of_child(), kOutlived);
}

TEST_F(GuardianTest, LasersGoOffWhenItDiesItself) {
  Guardian guardian;
  guardian.watch(circuit_.address(), 60);
  circuit_.start();
  const auto port = open_port(circuit_.address());
  PulseGenerator::Settings settings;
  settings.keep_alive_timeout = 1000;
  PulseGenerator generator(*port, &guardian, settings, {[](const Pulse&) {}, [] {}});
  generator.arm({100, 3, 0});
  ASSERT_TRUE(lasers_are_on());
  kill(guardian.process(), SIGKILL);
  waitpid(guardian.process(), nullptr, 0);
  EXPECT_TRUE(lines_go_low());
  EXPECT_TRUE(wait_for([&] { return !generator.status().armed; }));
  EXPECT_NE(generator.status().message.find("guardian"), std::string::npos);
}

TEST_F(GuardianTest, NothingIsArmedWithoutIt) {
  Guardian guardian;
  guardian.watch(circuit_.address(), 60);
  kill(guardian.process(), SIGKILL);
  waitpid(guardian.process(), nullptr, 0);
  circuit_.start();
  const auto port = open_port(circuit_.address());
  PulseGenerator generator(*port, &guardian, {}, {[](const Pulse&) {}, [] {}});
  EXPECT_THROW(generator.arm({100, 3, 0}), scan_cell_common::ConnectionError);
  for (const TestCircuit::Write& write : circuit_.writes())
    EXPECT_EQ(write.data & kLasers, 0);
}

TEST_F(GuardianTest, SaysWhatItCannotOpen) {
  Guardian guardian;
  try {
    guardian.watch(PortAddress::parallel("/dev/no_such_port"), 1);
    FAIL();
  } catch (const scan_cell_common::ConnectionError& error) {
    EXPECT_NE(std::string(error.what()).find("/dev/no_such_port: no such device"),
              std::string::npos);
  }
}

TEST(ParallelPort, IsRefusedByItsReason) {
  EXPECT_THROW(ParallelPort("/dev/no_such_port"), NoDevice);
  EXPECT_THROW(ParallelPort("/dev/null").write(0), NoDevice);  // exists, but is no parallel port
  const std::string locked = testing::TempDir() + "/locked_port";
  std::ofstream(locked).close();
  chmod(locked.c_str(), 0);
  const int child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {  // as an unprivileged user: root may open everything
    if (setuid(65534) != 0) _exit(3);
    try {
      ParallelPort port(locked);
      _exit(2);
    } catch (const NoPermission&) {
      _exit(0);
    }
  }
  int status = -1;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0);
  unlink(locked.c_str());
}

TEST(PortAddress, RefusesWhatDoesNotFit) {
  EXPECT_THROW(PortAddress::parallel(""), scan_cell_common::InvalidParameter);
  EXPECT_THROW(PortAddress::parallel(std::string(200, 'x')), scan_cell_common::InvalidParameter);
  EXPECT_THROW(open_port(PortAddress::loopback("localhost", 5)),
               scan_cell_common::InvalidParameter);
}
