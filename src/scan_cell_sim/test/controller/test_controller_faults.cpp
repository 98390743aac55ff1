// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause

/// Faults of a wire and a controller on request: the wire by itself in simulated time, and both
/// together on real sockets.
#include <atomic>
#include <cmath>
#include <mutex>
#include <set>

#include "controller/bare_client.h"
#include "controller/wire/faulty_wire.h"
#include "scan_cell_common/clock/host_clock.h"
#include "scan_cell_common/errors/errors.h"

using scan_cell_common::from_seconds;
using scan_cell_common::host_now;
using scan_cell_sim::Controller;
using scan_cell_sim::ControllerFaults;
using scan_cell_sim::FaultyWire;
using scan_cell_sim::MotionStatus;
using scan_cell_sim::WireFaults;

namespace {

/// Datagrams sent through a wire, one per millisecond, each with its number as the text.
class Passage {
 public:
  Passage(const WireFaults& faults, unsigned seed, int count = 20000) : count_(count) {
    FaultyWire wire(seed);
    const auto take = [&](Nanoseconds now) {
      while (const auto datagram = wire.take(now))
        came_.push_back({now, datagram->text});
    };
    for (int i = 0; i < count; ++i) {
      wire.put({{}, text(i)}, faults, sent(i));
      take(sent(i));
    }
    while (const auto due = wire.next_due())
      take(*due);
  }

  static Nanoseconds sent(int number) { return number * Nanoseconds{1'000'000}; }
  static std::string text(int number) { return std::to_string(1'000'000 + number); }

  struct Arrival {
    Nanoseconds time;
    std::string text;
  };
  const std::vector<Arrival>& came() const { return came_; }

  /// [ns] Delay of each datagram that arrived unchanged.
  std::vector<Nanoseconds> delays() const {
    std::vector<Nanoseconds> result;
    for (const Arrival& arrival : came_)
      result.push_back(arrival.time - sent(std::stoi(arrival.text) - 1'000'000));
    return result;
  }

  double share(double number) const { return number / count_; }

 private:
  int count_;
  std::vector<Arrival> came_;
};

constexpr double kFiveSigma = 0.018;  // of a share of a half of 20000

}  // namespace

TEST(FaultyWire, PassesAllInOrderAtOnceWhenItIsWell) {
  const Passage passage({}, 1);
  ASSERT_EQ(passage.came().size(), 20000u);
  for (int i = 0; i < 20000; ++i) {
    EXPECT_EQ(passage.came()[i].text, Passage::text(i));
    EXPECT_EQ(passage.came()[i].time, Passage::sent(i));
  }
}

TEST(FaultyWire, LosesAndRepeatsTheShareAskedFor) {
  WireFaults faults;
  faults.lost = 0.3;
  EXPECT_NEAR(Passage(faults, 1).share(Passage(faults, 1).came().size()), 0.7, kFiveSigma);
  faults.lost = 0;
  faults.repeated = 0.3;
  EXPECT_NEAR(Passage(faults, 1).share(Passage(faults, 1).came().size()), 1.3, kFiveSigma);
}

TEST(FaultyWire, LetsWhatIsDelayedBeOvertaken) {
  WireFaults faults;
  faults.delayed = 0.2;
  faults.delay = 0.0105;
  const Passage passage(faults, 1);
  ASSERT_EQ(passage.came().size(), 20000u);
  int late = 0;
  for (const Nanoseconds delay : passage.delays()) {
    late += delay > 0;
    EXPECT_TRUE(delay == 0 || delay >= from_seconds(0.0105));
    EXPECT_LE(delay, from_seconds(0.0115));  // taken with the next one sent
  }
  EXPECT_NEAR(passage.share(late), 0.2, kFiveSigma);
}

TEST(FaultyWire, SpreadsDelaysEvenlyUpToTheJitter) {
  WireFaults faults;
  faults.jitter = 0.1;
  double sum = 0;
  Nanoseconds longest = 0;
  const Passage passage(faults, 1);
  for (const Nanoseconds delay : passage.delays()) {
    sum += static_cast<double>(delay) * 1e-9;
    longest = std::max(longest, delay);
  }
  EXPECT_NEAR(passage.share(sum), 0.0505, 0.002);  // and half a millisecond until it is taken
  EXPECT_GT(longest, from_seconds(0.099));
  EXPECT_LE(longest, from_seconds(0.101));
}

TEST(FaultyWire, HoldsABurstAndBringsItAtOnceAndInOrder) {
  WireFaults faults;
  faults.held = 0.005;
  faults.hold = 0.05;
  const Passage passage(faults, 1);
  ASSERT_EQ(passage.came().size(), 20000u);
  int together = 0;
  int largest = 0;
  for (std::size_t i = 0; i < passage.came().size(); ++i) {
    EXPECT_EQ(passage.came()[i].text, Passage::text(static_cast<int>(i)));
    together = i > 0 && passage.came()[i].time == passage.came()[i - 1].time ? together + 1 : 1;
    largest = std::max(largest, together);
  }
  EXPECT_GE(largest, 50);
}

TEST(FaultyWire, FlipsOneToThreeBitsOrLosesTheEnd) {
  const auto bits_changed = [](const std::string& came, const std::string& sent) {
    int bits = 0;
    for (std::size_t i = 0; i < sent.size(); ++i)
      bits += __builtin_popcount(static_cast<unsigned char>(came[i] ^ sent[i]));
    return bits;
  };
  WireFaults faults;
  faults.flipped = 1;
  const Passage flipped(faults, 1);
  int changed = 0;
  for (int i = 0; i < 20000; ++i) {
    const std::string& came = flipped.came()[i].text;
    ASSERT_EQ(came.size(), Passage::text(i).size());
    EXPECT_LE(bits_changed(came, Passage::text(i)), 3);
    changed += came != Passage::text(i);
  }
  EXPECT_GT(changed, 19000);  // the same bit flipped twice is as it was
  faults.flipped = 0;
  faults.truncated = 1;
  const Passage truncated(faults, 1);
  for (int i = 0; i < 20000; ++i) {
    const std::string& came = truncated.came()[i].text;
    EXPECT_LT(came.size(), Passage::text(i).size());
    EXPECT_EQ(came, Passage::text(i).substr(0, came.size()));
  }
}

TEST(FaultyWire, DoesTheSameForTheSameSeedAndElseSomethingElse) {
  WireFaults mix;
  mix.lost = mix.repeated = mix.delayed = mix.flipped = mix.truncated = 0.1;
  mix.held = 0.01;
  mix.jitter = 0.003;
  const auto fate = [&mix](unsigned seed) {
    std::vector<std::pair<Nanoseconds, std::string>> all;
    const Passage passage(mix, seed, 2000);
    for (const auto& arrival : passage.came())
      all.emplace_back(arrival.time, arrival.text);
    return all;
  };
  EXPECT_EQ(fate(7), fate(7));
  EXPECT_NE(fate(7), fate(8));
}

TEST(ControllerFaults, AreRefusedByNameWhereTheyMakeNoSense) {
  const auto complaint = [](const std::function<void(ControllerFaults&)>& change) {
    ControllerFaults faults;
    change(faults);
    try {
      faults.check();
    } catch (const scan_cell_common::InvalidParameter& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(complaint([](ControllerFaults&) {}), "");
  EXPECT_EQ(complaint([](ControllerFaults& faults) { faults.to_client.lost = 1.5; }),
            "to_client/lost: 1.5; give 0 .. 1");
  EXPECT_EQ(complaint([](ControllerFaults& faults) { faults.from_client.delay = -1; }),
            "from_client/delay: -1 s; give 0 .. 10 s");
  EXPECT_NE(complaint([](ControllerFaults& faults) { faults.to_client.flipped = std::nan(""); }),
            "");
  EXPECT_NE(complaint([](ControllerFaults& faults) { faults.clock_drift = 1; }), "");
}

namespace {

class Faulty : public testing::Test {
 protected:
  scan_cell_sim::ControllerOptions options() {
    scan_cell_sim::ControllerOptions result = any_port();
    result.witness = [this](const scan_cell_sim::TakenUp& taken) {
      const std::lock_guard<std::mutex> lock(mutex_);
      seen_.push_back(taken.datagram);
      ++taken_up_;
    };
    return result;
  }

  bool eventually(const std::function<bool()>& condition) {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (std::chrono::steady_clock::now() < deadline) {
      if (condition()) return true;
      usleep(2000);
    }
    return false;
  }

  json request(std::uint64_t seq, json entries) {
    entries.update({{"c4g", 1}, {"session", 100}, {"seq", seq}});
    return entries;
  }

  std::mutex mutex_;
  std::vector<std::string> seen_;
  std::atomic<int> taken_up_{0};
  Controller controller_{options()};
  BareClient client_{controller_.port()};
};

}  // namespace

TEST_F(Faulty, SpoilsEveryDatagramOnRequest) {
  for (const auto fault : {&WireFaults::flipped, &WireFaults::truncated}) {
    controller_.set_faults({});
    ASSERT_EQ(code(client_.open(fault == &WireFaults::flipped ? 100 : 101)), 0);
    ControllerFaults faults;
    faults.to_client.*fault = 1;
    controller_.set_faults(faults);
    int good = 0;
    for (int i = 0; i < 50; ++i) {
      client_.send(request(2, {{"cmd", "GET_STATIC_POSE"}}));
      const std::string bytes = client_.receive_bytes(2000);
      good += scan_cell_sim::unsealed(bytes).has_value();
    }
    EXPECT_LE(good, 5);  // the same bit flipped twice
  }
}

TEST_F(Faulty, TakesUpNoRequestThatWasSpoiltOnItsWay) {
  client_.open();
  ControllerFaults faults;
  faults.from_client.flipped = 0.8;
  faults.from_client.truncated = 0.3;
  controller_.set_faults(faults);
  std::set<std::string> sent = {scan_cell_sim::sealed(request(1, {{"cmd", "OPEN"}}))};
  constexpr std::uint64_t kLast = 60;
  std::size_t tries = 0;
  for (std::uint64_t seq = 2; seq <= kLast; ++seq) {
    const json asked = request(seq, {{"cmd", "SET_OVERRIDE"}, {"override", seq}});
    sent.insert(scan_cell_sim::sealed(asked));
    ASSERT_TRUE(eventually([&] {
      ++tries;
      client_.send(asked);
      const json answer = client_.receive("ack", 5);
      return !answer.is_null() && answer["seq"] == seq;
    }));
  }
  EXPECT_GT(tries, 3 * kLast) << "one in seven comes unspoilt";
  const std::lock_guard<std::mutex> lock(mutex_);
  EXPECT_EQ(seen_.size(), kLast);
  for (const std::string& datagram : seen_)
    EXPECT_EQ(sent.count(datagram), 1u) << datagram;
}

TEST_F(Faulty, IsDumbForAWhileAndAnswersARetryAfterIt) {
  client_.open();
  ControllerFaults faults;
  faults.to_client.silence = 0.5;
  controller_.set_faults(faults);
  const int before = taken_up_;
  client_.send(request(2, move_to(800, 20, 600)));
  ASSERT_TRUE(eventually([&] { return taken_up_ > before; }));
  json answer = nullptr;
  ASSERT_TRUE(eventually([&] {
    client_.send(request(2, move_to(800, 20, 600)));
    answer = client_.receive("ack", 20);
    return !answer.is_null();
  }));
  EXPECT_EQ(code(answer), 0);
  EXPECT_EQ(taken_up_, before + 1);
  EXPECT_EQ(controller_.motions_begun(), 1u);
}

TEST_F(Faulty, IsDeafForAWhile) {
  client_.open();
  ControllerFaults faults;
  faults.from_client.silence = 0.3;
  const auto start = std::chrono::steady_clock::now();
  controller_.set_faults(faults);
  json answer = nullptr;
  ASSERT_TRUE(eventually([&] {
    client_.send(request(2, {{"cmd", "STOP"}}));
    answer = client_.receive("ack", 20);
    return !answer.is_null();
  }));
  EXPECT_GE(std::chrono::steady_clock::now() - start, std::chrono::milliseconds(300));
  EXPECT_EQ(code(answer), 0);
}

TEST_F(Faulty, RestartsWithANewClockAndNoSessionAndNeverResumes) {
  client_.open();
  client_.ask(2, {{"cmd", "SET_OVERRIDE"}, {"override", 60}});
  client_.ask(3, move_to(800, 350, 600));
  ASSERT_TRUE(eventually([this] { return controller_.state().flange.translation().y() > 0.02; }));
  const Nanoseconds restarted = host_now();
  controller_.restart(0.3);
  EXPECT_TRUE(eventually([this] { return controller_.state().status != MotionStatus::kMoving; }));
  const auto stopped = controller_.state().flange;
  client_.drain();
  json answer = nullptr;
  ASSERT_TRUE(eventually([&] {
    client_.send(request(3, move_to(800, 350, 600)));  // a retry of the motion that was begun
    answer = client_.receive("ack", 20);
    return !answer.is_null();
  }));
  EXPECT_EQ(code(answer), 3);
  const json opened = client_.open(101);
  EXPECT_EQ(code(opened), 0);
  EXPECT_EQ(opened["state"]["status"], "idle");
  EXPECT_EQ(opened["state"]["override"], 100);
  EXPECT_EQ(opened["state"]["drives"], true);
  EXPECT_EQ(opened["state"]["alarms"], json::array());
  EXPECT_EQ(controller_.motions_begun(), 1u);
  EXPECT_TRUE(controller_.state().flange.isApprox(stopped, 1e-12));
  EXPECT_GE(controller_.host_time(0), restarted + from_seconds(0.3)) << "a new clock";
  EXPECT_LE(controller_.host_time(opened["state"]["t"].get<std::int64_t>()), host_now());
}

TEST_F(Faulty, KeepsAnEmergencyStopOverARestart) {
  controller_.press_e_stop();
  controller_.restart(0.05);
  client_.drain();
  json answer = nullptr;
  ASSERT_TRUE(eventually([&] {
    client_.send(request(1, {{"cmd", "OPEN"}}));
    answer = client_.receive("ack", 20);
    return !answer.is_null();
  }));
  EXPECT_EQ(answer["state"]["e_stop"], true);
  EXPECT_EQ(answer["state"]["alarms"].size(), 1u);
  EXPECT_EQ(code(client_.ask(2, move_to(800, 20, 600))), 11);
}

TEST_F(Faulty, CarriesOutEachRequestOnceWhateverTheMix) {
  client_.open();
  ControllerFaults faults;
  for (WireFaults* const wire : {&faults.to_client, &faults.from_client}) {
    wire->lost = wire->repeated = wire->delayed = wire->flipped = 0.2;
    wire->truncated = 0.1;
    wire->delay = wire->jitter = 0.004;
    wire->held = 0.02;
    wire->hold = 0.02;
  }
  controller_.set_faults(faults);
  const int before = taken_up_;
  for (std::uint64_t seq = 2; seq < 52; ++seq) {
    ASSERT_TRUE(eventually([&] {
      client_.send(request(seq, {{"cmd", "SET_OVERRIDE"}, {"override", seq}}));
      const auto packet = scan_cell_sim::unsealed(client_.receive_bytes(20));
      return packet && (*packet)["type"] == "ack" && (*packet)["seq"] == seq;
    }));
  }
  EXPECT_EQ(taken_up_ - before, 50);
  EXPECT_NEAR(controller_.state().settings.override, 0.51, 1e-9);
}
