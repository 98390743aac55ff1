// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "alternating_chain.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "frame_client.h"
#include "laser_triangulation/triangulator.h"
#include "laser_trigger/pulse_generator.h"
#include "pose_frame_binder/binder.h"
#include "scan_cell_common/clock/host_clock.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_sim/cell.h"
#include "tecnogamma_camera/counter_unwrapper.h"
#include "tecnogamma_camera/peak_detector.h"

namespace scan_cell_demo {
namespace {

using laser_trigger::Pulse;
using laser_trigger::PulseGenerator;
using scan_cell_common::host_now;
using scan_cell_common::Nanoseconds;
using tecnogamma_camera::PeakProfile;

constexpr double kHeight = 0.4;      // [m] of the camera; at 0.5 the planes of both lasers cross
constexpr double kTolerance = 2e-3;  // [m] peaks are off by tenths of it, a wrong plane by 100 mm

/// The camera looks straight down from its height.
class Still : public scan_cell_sim::FlangeMotion {
 public:
  explicit Still(const Eigen::Isometry3d& flange_to_camera) {
    Eigen::Isometry3d camera = Eigen::Isometry3d::Identity();
    camera.translation().z() = kHeight;
    camera.linear() = Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX()).toRotationMatrix();
    flange_ = camera * flange_to_camera.inverse();
  }
  Eigen::Isometry3d flange_at(Nanoseconds) const override { return flange_; }

 private:
  Eigen::Isometry3d flange_;
};

scan_cell_sim::CellOptions cell_options(const AlternatingScan& scan) {
  scan_cell_sim::CellOptions options;
  options.scanner = scan_cell_common::load_scanner_model(scan.config + "/scanner.yaml");
  options.camera.genicam_file = scan.config + "/gige_camera.xml";
  options.camera.region.y = (options.scanner.camera.height - scan.rows) / 2;
  options.camera.region.height = scan.rows;
  options.trigger_port = 0;
  return options;
}

scan_cell_sim::World floor_alone() {
  scan_cell_sim::World world;
  world.floor = scan_cell_sim::Floor{};
  return world;
}

/// Binds frames to pulses, and makes points of the bound frames.
class Points {
 public:
  Points(const AlternatingScan& scan, const scan_cell_common::ScannerModel& model,
         const Eigen::Isometry3d& flange, AlternatingResult& result)
      : flange_(flange), triangulator_(model, {}), binder_(settings(scan)), result_(result) {}

  void add(const Pulse& pulse) {
    if (result_.pulses++ == 0) add_pose(pulse.time - kAround);
    binder_.add_pulse({pulse.time, pulse.arming, pulse.count, pulse.lasers});
  }

  void add(const Received& frame) {
    const auto step = unwrapper_.unwrap(frame.block);
    const std::size_t number = binder_.add_frame({1, step.count, frame.time, frame.fault});
    ++result_.frames;
    if (frame.fault.empty()) detector_->detect(frame.image(), waiting_[number]);
    add_pose(frame.time);
    last_ = std::max(last_, frame.time);
    take();
  }

  void end() {
    add_pose(last_ + kAround);
    binder_.end(result_.pulses);
    take();
    result_.uncertain = binder_.audit().frames_laser_uncertain;
  }

 private:
  static constexpr Nanoseconds kAround = 1'000'000'000;  // [ns] the flange never moves

  static pose_frame_binder::Settings settings(const AlternatingScan& scan) {
    pose_frame_binder::Settings settings;
    settings.camera_latency = scan.camera_latency;
    settings.max_pose_gap = 10;  // [s] the flange never moves, whatever is lost
    return settings;
  }

  void add_pose(Nanoseconds time) { binder_.add_pose({time, flange_}); }

  void take() {
    for (const pose_frame_binder::Decision& decision : binder_.take_decisions()) {
      if (decision.match) {
        ++result_.bound;
        make_points(waiting_[decision.frame], decision.match->laser, decision.match->pose);
      }
      waiting_.erase(decision.frame);
    }
  }

  void make_points(const PeakProfile& peaks, std::size_t laser, const Eigen::Isometry3d& flange) {
    for (const auto& point : triangulate(peaks, laser, flange)) {
      const double off = std::abs(static_cast<double>(point.z));
      ++result_.points[laser];
      result_.wrong += off > kTolerance;
      result_.worst = std::max(result_.worst, off);
    }
    for (const auto& point : triangulate(peaks, 1 - laser, flange))
      result_.swapped = std::min(result_.swapped, std::abs(static_cast<double>(point.z)));
  }

  std::vector<laser_triangulation::ScanPoint> triangulate(const PeakProfile& peaks,
                                                          std::size_t laser,
                                                          const Eigen::Isometry3d& flange) {
    std::vector<laser_triangulation::ScanPoint> points;
    triangulator_.add({laser, static_cast<std::uint32_t>(peaks.first_row), peaks.position.size(),
                       peaks.position.data(), peaks.width.data(), peaks.intensity.data()},
                      flange, points);
    return points;
  }

  const Eigen::Isometry3d flange_;
  laser_triangulation::Triangulator triangulator_;
  pose_frame_binder::Binder binder_;
  AlternatingResult& result_;
  tecnogamma_camera::CounterUnwrapper unwrapper_{tecnogamma_camera::kGigEVisionBlockId};
  std::unique_ptr<tecnogamma_camera::PeakDetector> detector_ =
      tecnogamma_camera::make_detector("fir_derivative", {});
  std::map<std::size_t, PeakProfile> waiting_;
  Nanoseconds last_ = 0;
};

/// The trigger on the circuit's wire, and its pulses since they were last taken.
class PulseSource {
 public:
  explicit PulseSource(std::uint16_t circuit)
      : port_(laser_trigger::open_port(laser_trigger::PortAddress::loopback("127.0.0.1", circuit))),
        generator_(*port_, nullptr, settings(),
                   {[this](const Pulse& pulse) { keep(pulse); }, [] {}}) {}

  void arm(const PulseGenerator::Arming& arming, std::uint64_t pulses) {
    last_ = pulses;
    generator_.arm(arming);
  }
  void disarm() { generator_.disarm("enough"); }
  laser_trigger::TriggerStatus status() const { return generator_.status(); }
  std::vector<Pulse> take() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return std::exchange(pulses_, {});
  }

 private:
  static PulseGenerator::Settings settings() {
    PulseGenerator::Settings settings;
    settings.keep_alive_timeout = std::numeric_limits<std::int32_t>::max();
    return settings;
  }
  void keep(const Pulse& pulse) {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      pulses_.push_back(pulse);
    }
    if (pulse.count == last_) disarm();
  }

  const std::unique_ptr<laser_trigger::TriggerPort> port_;
  std::mutex mutex_;
  std::vector<Pulse> pulses_;
  std::atomic<std::uint64_t> last_{0};
  PulseGenerator generator_;  // last: its thread uses all other members
};

}  // namespace

AlternatingResult run(const AlternatingScan& scan) {
  const scan_cell_sim::CellOptions options = cell_options(scan);
  const Still motion(options.scanner.flange_to_camera);
  scan_cell_sim::Cell cell(options, floor_alone(), motion);
  FrameClient camera(options.camera.address);
  PulseSource trigger(cell.circuit().port());
  const PulseGenerator::Arming dark = {50, 0};
  camera.wait_until_it_takes([&] { trigger.arm(dark, 0); }, [&] { trigger.disarm(); });
  trigger.take();
  scan_cell_sim::CameraFaults faults;
  faults.lost_frames = scan.lost_frames;
  cell.camera().set_faults(faults);

  AlternatingResult result;
  result.swapped = std::numeric_limits<double>::infinity();
  Points points(scan, options.scanner, motion.flange_at(0), result);
  trigger.arm({scan.rate, 3, 0, true, true}, scan.pulses);
  constexpr Nanoseconds kSilence = 1'000'000'000;  // [ns] after the last pulse
  for (Nanoseconds heard = host_now(); host_now() - heard < kSilence;) {
    const auto frame = camera.next();
    for (const Pulse& pulse : trigger.take())
      points.add(pulse);
    if (frame) points.add(*frame);
    if (frame || trigger.status().armed) heard = host_now();
  }
  points.end();
  result.missed = trigger.status().missed;
  return result;
}

}  // namespace scan_cell_demo
