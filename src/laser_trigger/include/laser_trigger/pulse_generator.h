// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <limits>
#include <mutex>
#include <string>
#include <thread>

#include "laser_trigger/guardian.h"
#include "laser_trigger/trigger_port.h"
#include "scan_cell_common/pose/timed_pose.h"

namespace laser_trigger {

using scan_cell_common::Nanoseconds;

/// One pulse that was sent.
struct Pulse {
  Nanoseconds time = 0;      //!< host time of the rising edge
  std::uint32_t arming = 0;  //!< the first is 1
  std::uint64_t count = 0;   //!< since this arming; the first is 1
  std::uint8_t lasers = 0;   //!< mask of the lasers that were on with it, bit 0: laser_0
  Nanoseconds late = 0;      //!< delay after its deadline
};

/// State of the pulse thread.
struct TriggerStatus {
  bool armed = false;        //!< lasers on, pulses running
  std::uint32_t arming = 0;  //!< the present or latest
  std::uint64_t pulses = 0;  //!< sent in this arming
  std::uint64_t missed = 0;  //!< deadlines missed in this arming
  double latest = 0;         //!< [s] greatest delay of a pulse of this arming
  double rate = 0;           //!< [Hz] 0: no pulses
  std::uint8_t lasers = 0;   //!< mask of the lasers that are on now or take turns
  bool alternate = false;    //!< they take turns: one is on at a time
  std::string message;       //!< why it was disarmed
  std::string failure;       //!< why the lines could not be set low then
};

/// Pulses the camera at a steady rate with the lasers on, and makes sure that they go off.
///
/// Deadlines are absolute and on the monotonic clock. A pulse that would come later than half a
/// period is left out and counted as missed, so two pulses are never closer than half a period.
///
/// Lasers that alternate take turns, starting with laser_0. They change places with one write of
/// the register, half a period after the pulse's deadline, or one exposure after its edge if that
/// is later. So the two are never on together, the frame of the pulse has been exposed, and the
/// next pulse waits until its laser is steady. The first pulses are twice as far apart, so that a
/// client that matches frames to pulses can detect an offset of one.
///
/// All lines are low from the constructor on. They are set low again on disarm(), without a
/// keep_alive() within its timeout, after the longest-on time, when the port or the guardian fails,
/// and at the end. While idle, zero is written again every second.
class PulseGenerator {
 public:
  /// Number of first pulses of an alternating arming that are followed by two periods instead of
  /// one; chosen: some of their frames may be lost.
  static constexpr std::uint64_t kSlowStart = 4;

  /// Settings of the pulse thread.
  struct Settings {
    double pulse_width = 200e-6;      //!< [s] how long the camera's line is high
    double max_rate = 1000;           //!< [Hz]
    double keep_alive_timeout = 0.5;  //!< [s]
    double longest_on = 300;          //!< [s] longest time an arming lasts, whatever was requested
    int realtime_priority = 50;       //!< SCHED_FIFO, where permitted; 0: never
    /// [s] after a pulse during which alternating lasers do not change, if an arming gives no
    /// exposure
    double exposure = 0.001;
    double exposure_delay = 100e-6;  //!< [s] of the camera's trigger input, added to an arming's
    double laser_rise = 200e-6;      //!< [s] for which an alternating laser is on before its pulse
  };
  /// What an arming requests.
  struct Arming {
    double rate = 0;          //!< [Hz] 0.1 or more
    std::uint8_t lasers = 0;  //!< mask, bit 0: laser_0
    double longest_on = 0;    //!< [s] 0: the settings'
    bool pulses = true;       //!< false: lasers only; the rate is not used
    bool alternate = false;   //!< both lasers take turns, pulse by pulse
    double exposure = 0;      //!< [s] of the camera; 0: the settings'
  };
  /// Called for pulses and changes.
  struct Observer {
    std::function<void(const Pulse&)> on_pulse;  //!< called by the pulse thread
    std::function<void()> on_change;             //!< after arming and disarming, by any thread
  };

  /// @param guardian nullptr only in tests that do not kill the process
  PulseGenerator(TriggerPort& port, Guardian* guardian, const Settings& settings,
                 const Observer& observer);
  ~PulseGenerator();

  /// @return its number
  /// @throw scan_cell_common::Refused if it is already armed, or the rate or the lasers are
  /// invalid
  /// @throw scan_cell_common::ConnectionError if circuit or guardian cannot be reached
  std::uint32_t arm(const Arming& arming);

  /// Checks whether arm() would accept it now, without writing to the port.
  /// @throw scan_cell_common::Refused as arm()
  void check(const Arming& arming) const;

  /// Sets the lines low.
  /// @return state of the arming that ended; arming 0 if there was none
  TriggerStatus disarm(const std::string& reason);

  void keep_alive();  //!< reports that the client is alive, so that the lasers may stay on
  TriggerStatus status() const;  //!< at this moment

  /// Why the pulse thread has normal scheduling; empty: it has real-time scheduling.
  const std::string& why_not_realtime() const { return why_not_realtime_; }

 private:
  using Clock = std::chrono::steady_clock;  // CLOCK_MONOTONIC

  std::string set_realtime_priority();
  void check_locked(const Arming& arming) const;
  void run();
  void generate();
  void send_pulse(Clock::time_point deadline, std::uint32_t arming);
  Clock::time_point take_turns(Clock::time_point earliest, std::uint32_t arming);
  std::string write_or_disarm(std::uint8_t data);
  bool wait_until(Clock::time_point time, std::uint32_t arming);
  bool still_armed(std::uint32_t arming);
  std::string reason_to_disarm(Clock::time_point now) const;
  void disarm_locked(const std::string& reason);
  std::string write_low() noexcept;

  TriggerPort& port_;
  Guardian* guardian_;
  const Settings settings_;
  const Observer observer_;

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  bool ending_ = false;
  TriggerStatus status_;
  Arming arming_;
  std::uint8_t lit_ = 0;    // mask of the lasers that are on at this moment
  Clock::time_point edge_;  // of the latest pulse, or shortly after it
  Clock::time_point armed_at_;
  Clock::time_point kept_alive_at_;
  Clock::time_point guardian_told_at_;
  Nanoseconds shortest_write_ = std::numeric_limits<Nanoseconds>::max();  // of a pulse
  std::thread thread_;
  std::string why_not_realtime_;
};

}  // namespace laser_trigger
