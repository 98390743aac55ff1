// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_sim/controller/offline_controller.h"

#include "controller/protocol_server.h"
#include "scan_cell_sim/controller/controller.h"

namespace scan_cell_sim {

struct OfflineController::Implementation {
  MotionControl motion{Controller::start_posture()};
  DriftingClock clock{0};
  ProtocolServer server{motion, clock, {}};
};

OfflineController::OfflineController() : implementation_(std::make_unique<Implementation>()) {}

OfflineController::~OfflineController() = default;

std::optional<std::string> OfflineController::answer(const std::string& request, Nanoseconds now) {
  return implementation_->server.answer({{}, request}, now);
}

std::optional<std::string> OfflineController::stream(Nanoseconds now) {
  return implementation_->server.stream(now);
}

MotionState OfflineController::state(Nanoseconds now) const {
  return implementation_->motion.state(now);
}

std::uint64_t OfflineController::motions_begun() const {
  return implementation_->motion.motions_begun();
}

}  // namespace scan_cell_sim
