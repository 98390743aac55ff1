// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
// The motion is an exact law; poses are that law at the controller's rate with its noise and the
// jitter of its stamps; pulses come at a rate of their own, at a random phase; the binder binds. A
// line of light lies across the motion, 0.5 m below the flange, its peaks noisy by 0.05 px. A
// perfect binding takes the pose at the instant of the pulse, with the same noise, and the same
// points. Interpolation can be better than that: it averages two poses.
#include "cloud_error.h"

#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

#include "pose_frame_binder/binder.h"

namespace pose_frame_binder {
namespace {

constexpr double kSpeed = 0.1;  // [m/s] at most
constexpr double kSeconds = 20;
constexpr double kFrameRate = 97.3;      // [Hz]
constexpr double kPositionNoise = 2e-5;  // [m] of a pose, each axis
constexpr double kAngleNoise = 3e-5;     // [rad], each axis
constexpr double kStampJitter = 5e-5;    // [s] of a pose
constexpr double kPeakNoise = 7e-5;      // [m] in depth: 0.05 px at 0.5 m

struct Motion {
  const char* name;
  double radius;  // [m] 0: straight
  double beat;    // [rad/s] of the speed between 0 and its most; 0: constant
};

Eigen::Isometry3d law(const Motion& motion, double t) {
  const double way =
      motion.beat > 0 ? kSpeed / 2 * (t - std::sin(motion.beat * t) / motion.beat) : kSpeed * t;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  if (motion.radius > 0) {
    const double angle = way / motion.radius;
    pose.translation() << motion.radius * std::sin(angle), motion.radius * (1 - std::cos(angle)), 0;
    pose.linear() = Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  } else {
    pose.translation().x() = way;
  }
  return pose;
}

class Noise {
 public:
  /// @param of_poses 1: as above; 0: none
  explicit Noise(double of_poses) : of_poses_(of_poses) {}

  double operator()(double deviation) { return deviation * normal_(random_); }
  Eigen::Isometry3d on(const Eigen::Isometry3d& pose) {
    const Eigen::Vector3d turn(of_angle(), of_angle(), of_angle());
    const Eigen::Vector3d shift(of_place(), of_place(), of_place());
    const Eigen::AngleAxisd turned(of_poses_ * turn.norm(), turn.normalized());
    return Eigen::Translation3d(of_poses_ * shift) * pose * turned;
  }

 private:
  double of_angle() { return (*this)(kAngleNoise); }
  double of_place() { return (*this)(kPositionNoise); }

  const double of_poses_;
  std::mt19937 random_{3};
  std::normal_distribution<double> normal_;
};

Nanoseconds at(double t) {
  constexpr Nanoseconds kStart = 1'700'000'000'000'000'000;
  return kStart + scan_cell_common::from_seconds(t);
}

struct Scan {
  std::vector<double> instants;  // [s] of the pulses
  std::vector<TimedPose> poses;
};

Scan record(const Motion& motion, double pose_rate, Noise& noise) {
  Scan scan;
  for (double t = -0.1; t < kSeconds + 0.1; t += 1 / pose_rate) {
    TimedPose pose;
    pose.time = at(t + noise(kStampJitter));
    pose.pose = noise.on(law(motion, t));
    scan.poses.push_back(pose);
  }
  constexpr double kPhase = 0.00317;  // [s]
  for (double t = kPhase; t < kSeconds; t += 1 / kFrameRate)
    scan.instants.push_back(t);
  return scan;
}

/// Poses of the pulses that got one; none for the others.
std::vector<std::optional<Eigen::Isometry3d>> bind(const Scan& scan, Method method) {
  Settings settings;
  settings.method = method;
  Binder binder(settings);
  for (const TimedPose& pose : scan.poses)
    binder.add_pose(pose);
  constexpr double kLatency = 0.004;
  for (std::size_t i = 0; i < scan.instants.size(); ++i) {
    binder.add_pulse({at(scan.instants[i]), 1, i + 1, 1});
    binder.add_frame({1, i, at(scan.instants[i] + kLatency), ""});
  }
  binder.end(scan.instants.size());
  std::vector<std::optional<Eigen::Isometry3d>> poses(scan.instants.size());
  for (const Decision& decision : binder.take_decisions())
    if (decision.match) poses[decision.frame] = decision.match->pose;
  return poses;
}

/// Root mean square distance [m] of the points from where they are in truth.
double cloud_error(const Motion& motion, const Scan& scan, double peak_noise,
                   const std::vector<std::optional<Eigen::Isometry3d>>& poses) {
  Noise noise(0);
  double squares = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Eigen::Isometry3d truth = law(motion, scan.instants[i]);
    for (double y = -0.1; y <= 0.1; y += 0.02) {
      const Eigen::Vector3d point(0, y, 0.5);
      const Eigen::Vector3d seen = point + Eigen::Vector3d(0, 0, noise(peak_noise));
      if (!poses[i]) continue;
      squares += (*poses[i] * seen - truth * point).squaredNorm();
      ++count;
    }
  }
  return std::sqrt(squares / static_cast<double>(count));
}

struct Errors {
  double perfect, interpolated, first_pose;  // [um]
};

Errors measure(const Motion& motion, double pose_rate, double pose_noise, double peak_noise) {
  Noise noise(pose_noise);
  const Scan scan = record(motion, pose_rate, noise);
  std::vector<std::optional<Eigen::Isometry3d>> perfect;
  for (const double t : scan.instants)
    perfect.emplace_back(noise.on(law(motion, t)));
  constexpr double kMicrometres = 1e6;
  const auto error = [&](const std::vector<std::optional<Eigen::Isometry3d>>& poses) {
    return kMicrometres * cloud_error(motion, scan, peak_noise, poses);
  };
  return {error(perfect), error(bind(scan, Method::Interpolate)),
          error(bind(scan, Method::FirstPose))};
}

void bench(const Motion& motion, double pose_rate) {
  const auto print = [&](const char* what, const Errors& e) {
    std::printf(
        "%-15s poses at %3.0f Hz, %s: perfect binding %4.1f um, interpolated %4.1f um, ratio %.2f "
        "(goal 1.2), first pose %5.1f um\n",
        motion.name, pose_rate, what, e.perfect, e.interpolated, e.interpolated / e.perfect,
        e.first_pose);
  };
  print("poses to 20 um", measure(motion, pose_rate, 1, kPeakNoise));
  print("exact poses   ", measure(motion, pose_rate, 0, kPeakNoise));
  const Errors alone = measure(motion, pose_rate, 0, 0);
  std::printf("%-15s poses at %3.0f Hz, binding alone: interpolated %.1f um, first pose %.1f um\n",
              motion.name, pose_rate, alone.interpolated, alone.first_pose);
}

}  // namespace

void bench_cloud_error() {
  constexpr double kBeat = 20;  // [rad/s] 1 m/s^2 at 100 mm/s
  for (const double pose_rate : {500.0, 250.0, 100.0}) {
    bench({"circle", 0.15, 0}, pose_rate);
    bench({"line, 1 m/s^2", 0, kBeat}, pose_rate);
    bench({"circle, 1 m/s^2", 0.15, kBeat}, pose_rate);
  }
}

}  // namespace pose_frame_binder
