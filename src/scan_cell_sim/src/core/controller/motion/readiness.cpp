// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_sim/controller/readiness.h"

#include <array>
#include <utility>

namespace scan_cell_sim {
namespace {

using Code = ControllerErrorCode;

constexpr std::size_t kMaxAlarms = 4;  // chosen: a state fits into a datagram

const char* const kPressed = "the emergency stop is pressed";
const std::string kReset = "an alarm is active, reset it first: ";

constexpr std::array<std::pair<ControllerMode, const char*>, 3> kModes = {
    {{ControllerMode::kProgramming, "programming"},
     {ControllerMode::kAutomatic, "automatic"},
     {ControllerMode::kRemote, "remote"}}};

}  // namespace

ControllerMode controller_mode_of(const std::string& name) {
  for (const auto& [mode, word] : kModes) {
    if (name == word) return mode;
  }
  throw ControllerRefusal(Code::kOutOfRange, "a mode is programming, automatic or remote");
}

const char* name_of(ControllerMode mode) {
  for (const auto& [known, word] : kModes) {
    if (mode == known) return word;
  }
  return "";
}

void Readiness::require_motion() const {
  if (e_stop_) throw ControllerRefusal(Code::kEmergencyStop, kPressed);
  if (!alarms_.empty()) {
    throw ControllerRefusal(Code::kAlarm, kReset + alarms_.front().text);
  }
  if (mode_ == ControllerMode::kAutomatic) {
    throw ControllerRefusal(Code::kMode, "motion is started at the panel in mode automatic");
  }
  if (!drives_) throw ControllerRefusal(Code::kEmergencyStop, "the drives are off");
}

void Readiness::select(ControllerMode mode) {
  if (mode == mode_) return;
  mode_ = mode;
  drives_ = false;
}

void Readiness::press_e_stop() {
  if (e_stop_) return;
  e_stop_ = true;
  raise({Code::kEmergencyStop, "emergency stop"});
}

void Readiness::restart() {
  alarms_.clear();
  drives_ = !e_stop_;
  if (!e_stop_) return;
  e_stop_ = false;
  press_e_stop();
}

void Readiness::raise(const Complaint& alarm) {
  drives_ = false;
  if (alarms_.size() == kMaxAlarms) alarms_.erase(alarms_.begin() + 1);  // the first says most
  alarms_.push_back(alarm);
}

void Readiness::reset_alarms(Source source) {
  require_right(source, "alarms are reset");
  if (e_stop_) throw ControllerRefusal(Code::kEmergencyStop, kPressed);
  alarms_.clear();
}

void Readiness::switch_drives(bool on, Source source) {
  if (on) {
    require_right(source, "drives are switched on");
    if (e_stop_) throw ControllerRefusal(Code::kEmergencyStop, kPressed);
    if (!alarms_.empty()) {
      throw ControllerRefusal(Code::kAlarm, kReset + alarms_.front().text);
    }
  }
  drives_ = on;
}

void Readiness::require_right(Source source, const std::string& what) const {
  if (source == Source::kPanel || mode_ == ControllerMode::kRemote) return;
  throw ControllerRefusal(Code::kMode,
                          what + " at the panel in mode " + std::string(name_of(mode_)));
}

}  // namespace scan_cell_sim
