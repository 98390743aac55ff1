// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "driver_diagnostics.h"

#include <diagnostic_msgs/DiagnosticStatus.h>

#include <cmath>

namespace c4g_driver {

using diagnostic_msgs::DiagnosticStatus;
using diagnostic_updater::DiagnosticStatusWrapper;

namespace {

bool got_worse(const LinkReport& before, const LinkReport& link) {
  return link.stream.lost > before.stream.lost || link.stream.reordered > before.stream.reordered ||
         link.stream.repeated > before.stream.repeated ||
         link.dropped.backward > before.dropped.backward ||
         link.malformed.count > before.malformed.count || link.foreign > before.foreign ||
         link.overlong > before.overlong;
}

/// Adds NaN if nothing was timed.
void add(DiagnosticStatusWrapper& status, const std::string& what,
         const scan_cell_common::Durations& durations) {
  const auto milliseconds = [&](double share) {
    return durations.count() > 0 ? 1e-6 * static_cast<double>(durations.quantile(share))
                                 : std::nan("");
  };
  status.addf(what + ", half within [ms]", "%.3f", milliseconds(0.5));
  status.addf(what + ", 99 % within [ms]", "%.3f", milliseconds(0.99));
}

}  // namespace

void LinkDiagnosis::report(const LinkReport& link, DiagnosticStatusWrapper& status) {
  const auto now = std::chrono::steady_clock::now();
  const std::chrono::duration<double> passed = now - asked_;
  if (!link.up) {
    status.summary(DiagnosticStatus::ERROR, "controller " + link.message);
  } else if (got_worse(before_, link)) {
    status.summary(DiagnosticStatus::WARN, "datagrams were lost, repeated, late or bad");
  } else {
    status.summary(DiagnosticStatus::OK, "connected");
  }
  status.add("times the link was lost", link.losses);
  status.add("attempts to connect since then", link.attempts);
  status.addf("positions a second", "%.1f",
              static_cast<double>(link.stream.received - before_.stream.received) / passed.count());
  status.add("positions received", link.stream.received);
  status.add("positions lost", link.stream.lost);
  status.add("positions repeated", link.stream.repeated);
  status.add("positions late, out of order", link.stream.reordered);
  status.add("positions dropped, overtaken by a later one", link.dropped.overtaken);
  status.add("positions dropped, stamp not after the one before", link.dropped.backward);
  add(status, "delay of the wire beyond its least", link.late.since(before_.late));
  add(status, "round trip of a request", link.round_trip.since(before_.round_trip));
  add(status, "from datagram to tf", link.hand_on.since(before_.hand_on));
  status.addf("controller's clock, drift [ppm]", "%.1f", 1e6 * link.clock.drift);
  status.addf("controller's clock, residual [us]", "%.1f",
              1e-3 * static_cast<double>(link.clock.residual));
  status.addf("controller's clock, watched for [s]", "%.1f",
              scan_cell_common::to_seconds(link.clock.history));
  status.add("controller's clock, times it or the host's was set", link.clock.steps);
  status.add("datagrams malformed", link.malformed.count);
  status.add("latest malformed", link.malformed.last);
  status.add("datagrams from others", link.foreign);
  status.add("datagrams too long", link.overlong);
  before_ = link;
  asked_ = now;
}

void report(const std::optional<MeasuredState>& state, DiagnosticStatusWrapper& status) {
  if (!state) {
    status.summary(DiagnosticStatus::STALE, "not known without a link");
    return;
  }
  const RobotState& robot = state->robot;
  if (robot.e_stop) {
    status.summary(DiagnosticStatus::ERROR, "emergency stop");
  } else if (!robot.alarms.empty()) {
    status.summary(DiagnosticStatus::ERROR,
                   std::string("alarm: ") + robot.alarms.front().text.c_str());
  } else if (robot.error) {
    status.summary(DiagnosticStatus::ERROR, robot.error->text.c_str());
  } else if (!takes_motions(robot)) {
    status.summary(DiagnosticStatus::WARN, robot.drives ? "automatic mode" : "drives off");
  } else {
    status.summary(DiagnosticStatus::OK,
                   robot.status == MotionStatus::kMoving ? "moving" : "ready");
  }
  status.add("override [%]", robot.override);
  status.add("linear speed [m/s]", robot.linear_speed);
}

}  // namespace c4g_driver
