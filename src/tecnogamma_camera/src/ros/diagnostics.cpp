// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "diagnostics.h"

#include <fmt/format.h>

namespace tecnogamma_camera {
namespace {

using diagnostic_msgs::DiagnosticStatus;

const char* to_text(AcquisitionMode mode) {
  switch (mode) {
    case AcquisitionMode::kLiveOnly:
      return "live only";
    case AcquisitionMode::kReliefOnly:
      return "relief only";
    case AcquisitionMode::kReliefLive:
      return "relief and live";
    default:
      return "stopped";
  }
}

const char* to_text(Trigger trigger) {
  return trigger == Trigger::kFreeRun ? "free run" : "external trigger";
}

/// Frames that are missing or damaged, for any reason.
std::uint64_t damage(const AcquisitionState& state) {
  return state.frames.incomplete + state.frames.lost + state.frames.unusable;
}

void summarise(const AcquisitionState& before, const AcquisitionState& now,
               const std::string& fault, diagnostic_updater::DiagnosticStatusWrapper& status) {
  if (!now.connected) return status.summary(DiagnosticStatus::ERROR, now.message);
  if (!fault.empty()) return status.summary(DiagnosticStatus::ERROR, fault);
  if (!now.message.empty()) return status.summary(DiagnosticStatus::WARN, now.message);
  if (damage(now) > damage(before)) {
    return status.summaryf(DiagnosticStatus::WARN, "%lu frames were lost or damaged",
                           static_cast<unsigned long>(damage(now) - damage(before)));
  }
  status.summary(DiagnosticStatus::OK, to_text(now.mode));
}

}  // namespace

void write_diagnostics(const AcquisitionState& before, const AcquisitionState& now,
                       const std::string& fault,
                       diagnostic_updater::DiagnosticStatusWrapper& status) {
  summarise(before, now, fault, status);
  status.add("camera", now.camera.id);
  status.add("sensor [px]",
             fmt::format("{} x {}", now.camera.sensor_columns, now.camera.sensor_rows));
  status.add("mode", to_text(now.mode));
  status.add("trigger", to_text(now.trigger));
  status.add("acquisition", now.acquisition);
  status.add("packet size [bytes]", now.camera.packet_size);
  status.add("frames received", now.frames.received);
  status.add("frames incomplete", now.frames.incomplete);
  status.add("frames lost", now.frames.lost);
  status.add("frames repeated", now.frames.repeated);
  status.add("frames late", now.frames.late);
  status.add("frames with a garbled number", now.frames.garbled);
  status.add("frames without number", now.frames.invalid);
  status.add("frames unusable", now.frames.unusable);
  status.add("last fault", now.fault);
  status.add("impossible peaks", now.frames.impossible_peaks);
  status.add("counter restarts", now.frames.restarts);
  status.add("stream completed", now.stream.completed);
  status.add("stream failures", now.stream.failures);
  status.add("stream underruns", now.stream.underruns);
  status.add("packets missing", now.stream.missing_packets);
  status.add("packets resent", now.stream.resent_packets);
  status.add("times lost", now.times_lost);
}

}  // namespace tecnogamma_camera
