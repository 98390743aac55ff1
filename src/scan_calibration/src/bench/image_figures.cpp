// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <unistd.h>

#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "images/board_detection.h"
#include "scan_calibration/observations.h"
#include "scan_calibration/session_recorder.h"
#include "session/rendered_session.h"
#include "session_figures.h"
#include "tecnogamma_camera/grey_image_file.h"

namespace fs = std::filesystem;

namespace scan_calibration {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector2d;

double seconds(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Sum of squares of the distance to the nearest true corner [px^2], an axis.
double squared_error(const std::vector<cv::Point2f>& corners, const RenderedSession& session,
                     const Isometry3d& pose) {
  double sum = 0;
  for (const cv::Point2f& corner : corners) {
    double least = 1e9;
    for (int i = 0; i < session.board.columns * session.board.rows; ++i) {
      const Vector2d truth = true_corner(session.truth.camera, pose, session.board,
                                         i % session.board.columns, i / session.board.columns);
      least = std::min(least, (truth - Vector2d(corner.x, corner.y)).squaredNorm());
    }
    sum += least / 2;
  }
  return sum / static_cast<double>(corners.size());
}

std::vector<cv::Point2f> to_opencv(const BoardCorners& corners) {
  std::vector<cv::Point2f> result;
  for (const Vector2d& corner : corners)
    if (corner.allFinite()) result.emplace_back(corner.x(), corner.y());
  return result;
}

void print_accuracy(const BoardRenderer& renderer, const RenderedSession& session, double blur,
                    double noise, double white) {
  RenderedScene scene;
  scene.board = session.board;
  scene.blur = blur;
  scene.noise = noise;
  scene.black *= white / scene.white;
  scene.table *= white / scene.white;
  scene.white = white;
  double ours = 0, sectors = 0, gradients = 0;
  int views = 0;
  for (const Isometry3d& pose : session.boards_in_camera) {
    const cv::Mat image = renderer.render(scene, pose, 1);
    const BoardCorners corners = find_board(image, session.board);
    std::vector<cv::Point2f> found;
    if (corners.empty() ||
        !cv::findChessboardCornersSB(image, {session.board.columns, session.board.rows}, found))
      continue;
    ++views;
    ours += squared_error(to_opencv(corners), session, pose);
    sectors += squared_error(found, session, pose);
    found = to_opencv(corners);  // a better start than its own
    cv::cornerSubPix(image, found, {11, 11}, {-1, -1}, cv::TermCriteria(3, 50, 1e-4));
    gradients += squared_error(found, session, pose);
  }
  const auto rms = [views](double sum) { return std::sqrt(sum / std::max(1, views)); };
  std::printf("  %4.1f %6.1f %6.0f %6d %10.4f %14.4f %14.4f\n", blur, noise, white, views,
              rms(ours), rms(gradients), rms(sectors));
}

/// 70 views: five rendered ones, repeated 14 times as if the robot stood a hair beside.
void record_large_session(const fs::path& folder) {
  constexpr int kRendered = 5;
  RenderedSession session = example_session(kRendered);
  auto& camera = session.truth.camera;
  camera.width = 1696;
  camera.height = 1710;
  camera.fx = camera.fy = 1350;
  camera.cx = 850;
  camera.cy = 853;
  session.board = {15, 25, 0.008};
  for (Isometry3d& pose : session.boards_in_camera)
    pose = pose * Eigen::Translation3d(0.02, -0.04, 0);  // the larger board in the middle
  const fs::path rendered = folder / "rendered";
  record(session, rendered.string(), false, 1);
  const Session original = load_session(rendered.string());
  std::vector<SessionView> views;
  const fs::path all = folder / "all";
  fs::create_directories(all);
  for (int i = 0; i < 70; ++i) {
    SessionView view = original.views[i % kRendered];
    const auto copy = [&](std::string& file) {
      const std::string name = std::to_string(i) + "_" + fs::path(file).filename().string();
      fs::create_hard_link(file, all / name);
      file = name;
    };
    copy(view.board_image);
    for (std::string& line : view.lines)
      copy(line);
    view.base_to_flange.translation().x() += 1e-7 * i;
    views.push_back(view);
  }
  std::ofstream(all / "poses.csv") << session_poses_text(views, original.lasers);
  std::ofstream(all / "session.yaml")
      << session_head_text({"poses.csv", session.board, original.lasers});
}

}  // namespace

void print_corner_accuracy() {
  const RenderedSession session = example_session(6);
  const BoardRenderer renderer(session.truth.camera, 6);
  std::printf(
      "\nCorners of rendered boards: RMS error along an axis [px]\n"
      "  blur  noise  white  views     fitted   cornerSubPix      sectors\n");
  for (const auto& [blur, noise, white] :
       {std::array{0.7, 0.5, 200.0}, std::array{0.7, 2.0, 200.0}, std::array{0.7, 5.0, 200.0},
        std::array{1.5, 2.0, 200.0}, std::array{2.5, 2.0, 200.0}, std::array{1.0, 1.0, 40.0}})
    print_accuracy(renderer, session, blur, noise, white);
}

void print_reading_time() {
  const fs::path folder = fs::temp_directory_path() / ("bench_session_" + std::to_string(getpid()));
  record_large_session(folder);
  const Session session = load_session((folder / "all").string());
  const double decoding = seconds([&] {
    for (const SessionView& view : session.views) {
      tecnogamma_camera::load_grey_image(view.board_image);
      for (const std::string& line : view.lines)
        tecnogamma_camera::load_grey_image(line);
    }
  });
  Observations seen;
  const double reading = seconds([&] { seen = observe(session); });
  std::size_t lines = 0;
  for (const ViewObservation& view : seen.views)
    for (const auto& line : view.lines)
      lines += line.empty() ? 0 : 1;
  std::printf(
      "\n70 views of 1696 x 1710, 15 x 25 corners, two lines: %.1f s on two threads (goal: 60 s); "
      "%zu boards and %zu lines found\n  decoding their 210 PNG alone, one thread: %.1f s\n",
      reading, seen.views.size(), lines, decoding);
  fs::remove_all(folder);
}

}  // namespace scan_calibration
