// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "session/rendered_session.h"

#include <cmath>

#include "scan_calibration/session_recorder.h"

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector3d;

Isometry3d RenderedSession::base_to_flange(std::size_t view) const {
  return base_to_board * boards_in_camera.at(view).inverse() * truth.flange_to_camera.inverse();
}

RenderedSession example_session(int views) {
  RenderedSession session;
  auto& camera = session.truth.camera;
  camera.width = 640;
  camera.height = 480;
  camera.fx = 521;
  camera.fy = 519;
  camera.cx = 322.5;
  camera.cy = 236.2;
  camera.distortion << -0.09, 0.06, 0.0007, -0.0005, 0;
  session.truth.flange_to_camera =
      Translation3d(0.01, -0.02, 0.09) * AngleAxisd(0.3, Vector3d(0.2, -0.1, 1).normalized());
  const double lean = 0.35;
  for (const double side : {-1.0, 1.0}) {
    scan_cell_common::LaserPlane laser;
    laser.normal = Vector3d(std::cos(lean), 0.01, side * std::sin(lean)).normalized();
    laser.distance = laser.normal.dot(Vector3d(0, 0, 0.3));
    laser.origin = laser.normal * laser.distance;
    session.truth.lasers.push_back(laser);
  }
  session.base_to_board =
      Translation3d(0.9, 0.1, 0.05) * AngleAxisd(0.4, Vector3d(0.1, 0.2, 1).normalized());
  for (int i = 0; i < views; ++i) {
    const double share = (i + 0.5) / views;
    const Vector3d centre(0.03 * std::sin(2.4 * i), 0.025 * std::cos(3.1 * i),
                          0.26 + 0.14 * std::fmod(0.618 * i, 1));
    session.boards_in_camera.push_back(
        board_pose(session.board, centre, 0.1 + 0.5 * share, 2.4 * i, 0.8 * std::sin(1.7 * i)));
  }
  return session;
}

void record(const RenderedSession& session, const std::string& folder, bool laser_in_board_image,
            int samples, const std::vector<std::string>& all) {
  const BoardRenderer renderer(session.truth.camera, samples);
  const std::vector<std::string> names =
      laser_in_board_image ? std::vector<std::string>{"laser_0"} : all;
  scan_calibration::SessionRecorder recorder(folder, session.board, names);
  for (std::size_t i = 0; i < session.boards_in_camera.size(); ++i) {
    const Isometry3d& pose = session.boards_in_camera[i];
    const auto seed = static_cast<std::uint32_t>(10 * i);
    RenderedScene scene;
    scene.board = session.board;
    RenderedScene lit = scene;
    lit.room_light = laser_in_board_image ? 0.2 : 0.05;
    lit.laser_light = 600;  // saturates on white
    std::vector<scan_calibration::RecordedLine> lines(names.size());
    if (laser_in_board_image) {
      lit.laser = session.truth.laser(0);
      const cv::Mat image = renderer.render(lit, pose, seed);
      lines[0].in_board_image = true;
      recorder.add(session.base_to_flange(i), image, lines);
      continue;
    }
    for (std::size_t laser = 0; laser < names.size(); ++laser) {
      lit.laser = session.truth.laser(scan_cell_common::laser_index(names[laser]));
      lines[laser].image = renderer.render(lit, pose, seed + 1 + static_cast<std::uint32_t>(laser));
    }
    recorder.add(session.base_to_flange(i), renderer.render(scene, pose, seed), lines);
  }
}
