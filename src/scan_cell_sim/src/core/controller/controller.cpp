// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_sim/controller/controller.h"

#include "controller/controller_loop.h"
#include "scan_cell_common/clock/host_clock.h"

namespace scan_cell_sim {

using scan_cell_common::host_now;
using scan_cell_common::Nanoseconds;

struct Controller::Implementation : ControllerLoop {
  using ControllerLoop::ControllerLoop;
};

Joints Controller::start_posture() {
  Eigen::Isometry3d flange = Eigen::Isometry3d::Identity();
  flange.translation() << 0.80, 0, 0.60;  // [m] chosen
  flange.linear() = Eigen::Vector3d(1, -1, -1).asDiagonal();
  static const Joints posture = reach(flange, Joints::Zero());
  return posture;
}

Controller::Controller(const ControllerOptions& options)
    : implementation_(std::make_unique<Implementation>(options, start_posture())) {}

Controller::~Controller() = default;

std::uint16_t Controller::port() const {
  return implementation_->port();
}

Eigen::Isometry3d Controller::flange_at(Nanoseconds host) const {
  const Run run = implementation_->motion().log().at(host);
  return run.path->flange(run.way(host));
}

std::uint32_t Controller::outputs_at(Nanoseconds host) const {
  return implementation_->motion().log().at(host).outputs(host);
}

MotionState Controller::state() const {
  return implementation_->motion().state(host_now());
}

std::uint64_t Controller::motions_begun() const {
  return implementation_->motion().motions_begun();
}

Nanoseconds Controller::host_time(std::int64_t t) const {
  return implementation_->clock().host(t);
}

void Controller::set_faults(const ControllerFaults& faults) {
  implementation_->set_faults(faults);
}

void Controller::restart(double dark) {
  implementation_->restart(dark);
}

void Controller::press_e_stop() {
  implementation_->motion().press_e_stop(host_now());
}

void Controller::release_e_stop() {
  implementation_->motion().release_e_stop();
}

void Controller::select(ControllerMode mode) {
  implementation_->motion().select(mode, host_now());
}

void Controller::switch_drives(bool on) {
  implementation_->motion().switch_drives(on, Readiness::Source::kPanel, host_now());
}

void Controller::reset_alarms() {
  implementation_->motion().reset_alarms(Readiness::Source::kPanel);
}

void Controller::fail_motion(const std::string& text) {
  implementation_->motion().fail(text, host_now());
}

}  // namespace scan_cell_sim
