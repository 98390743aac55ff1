// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <numeric>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>
#include <random>

#include "camera_calibration.h"
#include "images/board_detection.h"
#include "quality/figures.h"
#include "scan_calibration/calibration_run.h"
#include "scan_cell_common/errors/errors.h"
#include "sequential.h"
#include "session_figures.h"
#include "tecnogamma_camera/grey_image_file.h"

namespace fs = std::filesystem;

namespace scan_calibration {
namespace {

/// A model's state for views that it was not fitted to.
ScannerState state_of(const scan_cell_common::ScannerModel& model,
                      const Eigen::Isometry3d& base_to_board, const Eigen::Vector3d& bend) {
  ScannerState state;
  state.width = model.camera.width;
  state.height = model.camera.height;
  state.camera = camera_vector(model.camera);
  state.flange_to_camera = model.flange_to_camera;
  state.base_to_board = base_to_board;
  state.bend = bend;
  for (const auto& laser : model.lasers)
    state.planes.emplace_back(laser->normal / laser->distance);
  return state;
}

/// RMS distance [mm] of the first laser's points from its plane.
double plane_rms_mm(const ScannerState& state, const Board& board, const BoardViews& views) {
  SquareSum sum;
  for (const JudgedView& view : judge(state, BoardSurface(board), views))
    sum.add(view.planes.front());
  return 1e3 * sum.rms();
}

/// Both methods on a few views of a session, drawn at random, judged on all other views.
struct FewViews {
  int fitted = 0, refused = 0, worse = 0;
  double joint = 0, sequential = 0;  // sums of logarithms
  double worst = 0;                  // joint over sequential

  void add(double joint_mm, double sequential_mm) {
    ++fitted;
    worse += joint_mm > sequential_mm ? 1 : 0;
    worst = std::max(worst, joint_mm / sequential_mm);
    joint += std::log(joint_mm);
    sequential += std::log(sequential_mm);
  }
};

FewViews try_few_views(const Observations& used, std::size_t count) {
  constexpr int kDraws = 30;  // chosen
  std::mt19937 generator(static_cast<unsigned>(count));
  FewViews result;
  for (int draw = 0; draw < kDraws; ++draw) {
    std::vector<std::size_t> order(used.views.size());
    std::iota(order.begin(), order.end(), 0);
    for (std::size_t i = order.size() - 1; i > 0; --i)
      std::swap(order[i], order[generator() % (i + 1)]);
    std::sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count));
    Observations some = used;
    some.views.clear();
    BoardViews others;
    for (std::size_t i = 0; i < order.size(); ++i) {
      if (i < count) some.views.push_back(used.views[order[i]]);
      if (i >= count) others.push_back(board_view(used, order[i]));
    }
    try {
      const Calibration joint = calibrate(some, {});
      const SequentialCalibration steps = calibrate_sequentially(used_views(some, joint), 5);
      result.add(plane_rms_mm(state_of(joint.scanner, joint.base_to_board, joint.board_bend),
                              used.board, others),
                 plane_rms_mm(state_of(steps.scanner, steps.base_to_board, {0, 0, 0}), used.board,
                              others));
    } catch (const scan_cell_common::UnusableInput&) {
      ++result.refused;
    }
  }
  return result;
}

void print_few_views(const Observations& used) {
  std::printf("few of its views, laser plane on all others [mm RMS, geometric mean]\n");
  for (const std::size_t count : {6, 7, 8, 10}) {
    if (count + 3 > used.views.size()) continue;
    const FewViews few = try_few_views(used, count);
    if (few.fitted == 0) continue;
    std::printf(
        "  %2zu views: joint %.3f, step by step %.3f; joint worse in %d of %d, "
        "at most %.2f times; %d draws refused\n",
        count, std::exp(few.joint / few.fitted), std::exp(few.sequential / few.fitted), few.worse,
        few.fitted, few.worst, few.refused);
  }
}

void print_session(const fs::path& folder) {
  const CalibrationRun run = run_calibration(folder.string(), {}, {}, {});
  std::printf("\n%s: ", folder.filename().c_str());
  if (!run.calibration) {
    std::printf("refused: %s\n", run.reason.c_str());
    return;
  }
  const Calibration& joint = *run.calibration;
  std::printf("%zu of %d views\n", joint.views.size(), run.taken);
  std::printf("%-28s %22s %22s\n", "", "joint estimate", "one after the other");
  std::printf("%-28s %10s %11s %10s %11s\n", "", "fitted", "held out", "fitted", "held out");
  const auto print = [&](const std::string& name, const auto& value) {
    std::printf("%-28s %10.3f %11.3f %10.3f %11.3f\n", name.c_str(), value(joint.fitted),
                value(joint.held_out), value(run.sequential->fitted),
                value(run.sequential->held_out));
  };
  print("reprojection [px RMS]", [](const Figures& f) { return f.reprojection_rms_px; });
  for (std::size_t i = 0; i < run.observations.lasers.size(); ++i) {
    print(run.observations.lasers[i] + " plane [mm RMS]",
          [i](const Figures& f) { return f.laser_plane_rms_mm.at(i); });
  }
  print("board's centre [mm RMS]", [](const Figures& f) { return f.board_scatter_mm; });
  if (!run.observations.lasers.empty()) print_few_views(used_views(run.observations, joint));
}

/// Finds the corners as OpenCV's sample does, on which its published figure is based.
BoardCorners published_corners(const cv::Mat& image, const Board& board) {
  std::vector<cv::Point2f> found;
  if (!cv::findChessboardCorners(image, {board.columns, board.rows}, found)) return {};
  cv::cornerSubPix(image, found, {11, 11}, {-1, -1}, cv::TermCriteria(3, 30, 0.1));
  BoardCorners corners;
  for (const cv::Point2f& corner : found)
    corners.emplace_back(corner.x, corner.y);
  return corners;
}

template <class Find>
Observations look_at(const std::vector<fs::path>& images, const Board& board, const Find& find) {
  Observations seen;
  seen.board = board;
  for (const fs::path& path : images) {
    const cv::Mat image = tecnogamma_camera::load_grey_image(path.string());
    seen.width = image.cols;
    seen.height = image.rows;
    ViewObservation view;
    view.name = path.filename().string();
    view.base_to_flange = Eigen::Isometry3d::Identity();
    const BoardCorners corners = find(image, board);
    for (int i = 0; i < static_cast<int>(corners.size()); ++i) {
      if (corners[i].allFinite())
        view.corners.push_back({i % board.columns, i / board.columns, corners[i]});
    }
    if (view.corners.empty()) {
      seen.rejected.push_back({view.name, "", "the board is not seen"});
    } else {
      seen.views.push_back(view);
    }
  }
  return seen;
}

void print_camera(const char* name, const Observations& seen, bool reject) {
  CameraOptions options;
  options.square_pixels = true;  // as in the published flags
  options.reject_views = reject;
  const CameraCalibration result = calibrate_camera(seen, options);
  std::printf("  %-50s %8.4f px, %zu views", name, result.reprojection_rms_px, result.views.size());
  for (const RejectedView& view : result.rejected)
    std::printf("; without %s: %s", view.name.c_str(), view.reason.c_str());
  std::printf("\n");
}

void print_opencv_images() {
  const fs::path folder = "/usr/share/doc/opencv-doc/examples/data";
  std::vector<fs::path> images;
  for (int i = 1; i <= 14; ++i) {
    char name[16];
    std::snprintf(name, sizeof name, "left%02d.jpg", i);
    if (fs::exists(folder / name)) images.push_back(folder / name);
  }
  if (images.empty()) {
    std::printf("\nNot run: OpenCV's images; install opencv-doc\n");
    return;
  }
  std::printf("\nOpenCV's left images, one focal length; published: 0.3926 px, 13 views\n");
  const Board board{9, 6, 0.025};
  const Observations published = look_at(images, board, published_corners);
  print_camera("corners as published, every view", published, false);
  print_camera("corners as published, robust", published, true);
  const Observations ours = look_at(images, board, find_board);
  print_camera("fitted corners, every view", ours, false);
  print_camera("fitted corners, robust", ours, true);
}

}  // namespace

void print_real_sessions() {
  const char* data = std::getenv("SCAN_CELL_DATA");
  const fs::path sessions = fs::path(data == nullptr ? "" : data) / "handeye_laser";
  if (data == nullptr || !fs::is_directory(sessions)) {
    std::printf("Not run: sessions; SCAN_CELL_DATA names no folder that holds handeye_laser/\n");
  } else {
    std::vector<fs::path> folders;
    for (const auto& entry : fs::directory_iterator(sessions))
      if (fs::exists(entry.path() / "session.yaml")) folders.push_back(entry.path());
    std::sort(folders.begin(), folders.end());
    for (const fs::path& folder : folders)
      print_session(folder);
  }
  print_opencv_images();
}

}  // namespace scan_calibration
