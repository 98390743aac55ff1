// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
// Goals of a calibration on seeded synthetic sessions of 70 views: each figure beside its goal, and
// the step-by-step method on the same views.
#include <CLI/CLI.hpp>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "estimate/synthetic_session.h"
#include "estimate/truth_comparison.h"
#include "laser_triangulation/triangulator.h"
#include "scan_calibration/calibration.h"
#include "scan_cell_common/tools/tool_main.h"
#include "sequential.h"

namespace {

using Eigen::Isometry3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using scan_calibration::Calibration;
using scan_calibration::Figures;

/// Largest value of each figure over the sessions.
struct Worst {
  double reprojection_px = 0, plane_mm[2] = {0, 0}, scatter_mm = 0, flatness_mm = 0;

  void add(const Figures& figures) {
    reprojection_px = std::max(reprojection_px, figures.reprojection_rms_px);
    for (std::size_t laser = 0; laser < 2; ++laser)
      plane_mm[laser] = std::max(plane_mm[laser], figures.laser_plane_rms_mm[laser]);
    scatter_mm = std::max(scatter_mm, figures.board_scatter_mm);
  }
};

/// The column [px] where a laser's light on a plane falls on a row of the sensor.
double column_of(const scan_cell_common::ScannerModel& scanner, std::size_t laser,
                 const Vector3d& normal, double distance, double row) {
  const scan_cell_common::LaserPlane& light = scanner.laser(laser);
  Vector2d distorted(0, (row - scanner.camera.cy) / scanner.camera.fy);
  Vector3d point = Vector3d::UnitZ();
  constexpr int kSteps = 50;  // the lens bends the row
  for (int step = 0; step < kSteps; ++step) {
    Vector2d ray = distorted;
    if (!scanner.camera.undistort(distorted, ray)) return NAN;
    Eigen::Matrix3d rows;
    rows << light.normal.transpose(), normal.transpose(), 0, 1, -ray.y();
    point = rows.inverse() * Vector3d(light.distance, distance, 0);
    distorted.x() = scanner.camera.distort(point.head<2>() / point.z()).x();
  }
  return scanner.camera.project(point).x();
}

/// RMS height [mm] of a plane that is lit by the true laser and triangulated by the calibrated
/// model.
double flatness_mm(const synthetic::Cell& cell, const scan_cell_common::ScannerModel& scanner) {
  laser_triangulation::Triangulator triangulator(scanner, {});
  std::vector<laser_triangulation::ScanPoint> points;
  for (int step = 0; step < 50; ++step) {
    Isometry3d flange = Isometry3d::Identity();
    flange.linear() = Eigen::AngleAxisd(M_PI, Vector3d::UnitX()).toRotationMatrix();
    flange.translation() << 0.5 + 0.005 * step, 0, 0.58;
    const Isometry3d to_camera = (flange * cell.scanner.flange_to_camera).inverse();
    const Vector3d normal = to_camera.linear() * Vector3d::UnitZ();
    for (std::size_t laser = 0; laser < 2; ++laser) {
      std::vector<float> columns(1710, NAN), ones(1710, 1.F);
      for (std::size_t row = 5; row < columns.size(); row += 10)
        columns[row] = static_cast<float>(column_of(cell.scanner, laser, normal,
                                                    normal.dot(to_camera.translation()),
                                                    static_cast<double>(row)));
      triangulator.add({laser, 0, columns.size(), columns.data(), ones.data(), ones.data()}, flange,
                       points);
    }
  }
  double squares = 0;
  for (const laser_triangulation::ScanPoint& point : points)
    squares += double{point.z} * point.z;
  return 1e3 * std::sqrt(squares / static_cast<double>(points.size()));
}

void print(const char* name, const Worst& joint, const Worst& steps) {
  std::printf("%s, worst session        %10s %14s %10s\n", name, "joint", "step by step", "goal");
  std::printf("  reprojection [px RMS]        %10.4f %14.4f %10.4f\n", joint.reprojection_px,
              steps.reprojection_px, 0.1586);
  const double goals[] = {0.2787, 0.4413};
  for (std::size_t laser = 0; laser < 2; ++laser)
    std::printf("  laser_%zu plane [mm RMS]       %10.4f %14.4f %10.4f\n", laser,
                joint.plane_mm[laser], steps.plane_mm[laser], goals[laser]);
  std::printf("  board scatter [mm RMS]       %10.4f %14.4f %10s\n", joint.scatter_mm,
              steps.scatter_mm, "-");
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// @param sequential number of sessions that are also calibrated step by step
void bench(unsigned sessions, unsigned sequential) {
  const synthetic::Cell cell;
  unsigned inside = 0;
  std::size_t rejected = 0;
  double joint_seconds = 0, sequential_seconds = 0;
  Worst fitted, held_out, fitted_steps, held_out_steps;
  for (unsigned seed = 1; seed <= sessions; ++seed) {
    const scan_calibration::Observations observations = goal_session(cell, seed);
    auto start = std::chrono::steady_clock::now();
    const Calibration joint = scan_calibration::calibrate(observations, {});
    joint_seconds += seconds_since(start);
    const auto [miss, name] = worst_miss(cell, joint);
    inside += miss < 3;
    if (miss >= 3) std::printf("session %u: %s is %.2f deviations off\n", seed, name.c_str(), miss);
    rejected += joint.rejected.size();
    fitted.add(joint.fitted);
    held_out.add(joint.held_out);
    held_out.flatness_mm = std::max(held_out.flatness_mm, flatness_mm(cell, joint.scanner));
    if (seed > sequential) continue;
    start = std::chrono::steady_clock::now();
    const scan_calibration::SequentialCalibration steps =
        scan_calibration::calibrate_sequentially(used_views(observations, joint), 5);
    sequential_seconds += seconds_since(start);
    fitted_steps.add(steps.fitted);
    held_out_steps.add(steps.held_out);
  }
  std::printf("%u sessions: 70 views, board 15 x 25 of 20 mm, 0.1 px, robot 0.05 mm, 0.05 mrad\n",
              sessions);
  std::printf("every parameter within 3 stated deviations: %u of %u, goal 95 of 100\n", inside,
              sessions);
  std::printf("views and lines rejected, none of them bad: %zu\n", rejected);
  print("fitted  ", fitted, fitted_steps);
  print("held out", held_out, held_out_steps);
  std::printf("a scanned plane's height [mm RMS], worst: %.4f, goal 0.1\n", held_out.flatness_mm);
  std::printf("time a session [s]: %.2f, step by step %.2f\n", joint_seconds / sessions,
              sequential_seconds / std::max(1u, std::min(sequential, sessions)));
}

/// Sessions of seven views: what held-out views say of the two methods, and what is true.
void bench_few_views(unsigned sessions) {
  const synthetic::Cell cell;
  double held_out[2] = {0, 0}, truth[2] = {0, 0};
  unsigned held_out_worse = 0, truly_worse = 0, count = 0;
  for (unsigned seed = 1; seed <= sessions; ++seed) {
    synthetic::Poses poses;
    poses.count = 7;
    poses.seed = seed;
    const scan_calibration::Observations observations =
        observe(cell, flange_poses(cell, poses), {0.1, 0.1, 5e-5, 5e-5}, seed);
    const Calibration joint = scan_calibration::calibrate(observations, {});
    const scan_calibration::SequentialCalibration steps =
        scan_calibration::calibrate_sequentially(used_views(observations, joint), 5);
    const double flatness[2] = {flatness_mm(cell, joint.scanner), flatness_mm(cell, steps.scanner)};
    truly_worse += flatness[0] > flatness[1];
    for (int way = 0; way < 2; ++way)
      truth[way] += flatness[way] * flatness[way];
    for (std::size_t laser = 0; laser < 2; ++laser, ++count) {
      const double plane[2] = {joint.held_out.laser_plane_rms_mm[laser],
                               steps.held_out.laser_plane_rms_mm[laser]};
      held_out_worse += plane[0] > plane[1];
      for (int way = 0; way < 2; ++way)
        held_out[way] += plane[way] * plane[way];
    }
  }
  const auto rms = [](double squares, unsigned of) {
    return std::sqrt(squares / std::max(1U, of));
  };
  std::printf("%u sessions of 7 views               joint   step by step   joint is worse\n",
              sessions);
  std::printf("  a plane, held out [mm RMS]   %10.4f %14.4f     in %u of %u\n",
              rms(held_out[0], count), rms(held_out[1], count), held_out_worse, count);
  std::printf("  a scanned plane's height     %10.4f %14.4f     in %u of %u\n",
              rms(truth[0], sessions), rms(truth[1], sessions), truly_worse, sessions);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Calibrations of synthetic sessions beside their goals.");
  unsigned sessions = 100, sequential = 5, few = 30;
  app.add_option("--sessions", sessions, "how many, each with its own poses and noise")
      ->capture_default_str();
  app.add_option("--step-by-step", sequential, "how many of them also one step after the other")
      ->capture_default_str();
  app.add_option("--few", few, "how many sessions of seven views")->capture_default_str();
  return scan_cell_common::tool_main("bench_joint_estimate", app, argc, argv, [&] {
    bench(sessions, sequential);
    bench_few_views(few);
    return 0;
  });
}
