// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_calibration/calibration_files.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <limits>
#include <set>

#include "report/report.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"
#include "scan_cell_common/scanner/point_deviations.h"

namespace fs = std::filesystem;

namespace scan_calibration {
namespace {

std::string time_written(const std::string& path) {
  struct stat status {};
  std::tm utc{};
  char text[32] = "before";
  if (stat(path.c_str(), &status) == 0 && gmtime_r(&status.st_mtime, &utc) != nullptr)
    std::strftime(text, sizeof text, "%Y%m%d_%H%M%S", &utc);
  return text;
}

std::string with_stem(const fs::path& path, const std::string& added) {
  return (path.parent_path() / (path.stem().string() + added + path.extension().string())).string();
}

std::string matrix_text(const std::string& name, int rows, int columns,
                        const std::vector<double>& values) {
  return fmt::format("{}:\n  rows: {}\n  cols: {}\n  data: [{:.17g}]\n", name, rows, columns,
                     fmt::join(values, ", "));
}

/// Copies a file to a name beside it with the time at which it was written.
/// @return the copy's path; empty if there is no file
std::string keep_old(const std::string& path) {
  if (!fs::exists(path)) return {};
  const std::string name = "_" + time_written(path);
  std::string kept = with_stem(path, name);
  for (int i = 2; fs::exists(kept); ++i)
    kept = with_stem(path, fmt::format("{}_{}", name, i));
  scan_cell_common::save_text(kept, scan_cell_common::read_file(path));
  return kept;
}

/// Saves the camera as camera_calibration_parsers reads it.
void save_camera_info(const std::string& path, const scan_cell_common::CameraIntrinsics& camera) {
  const auto& [width, height, fx, fy, cx, cy, distortion] = camera;
  scan_cell_common::save_text(
      path,
      fmt::format(
          "image_width: {}\nimage_height: {}\ncamera_name: camera\n{}"
          "distortion_model: plumb_bob\n{}{}{}",
          width, height, matrix_text("camera_matrix", 3, 3, {fx, 0, cx, 0, fy, cy, 0, 0, 1}),
          matrix_text("distortion_coefficients", 1, 5, {distortion.begin(), distortion.end()}),
          matrix_text("rectification_matrix", 3, 3, {1, 0, 0, 0, 1, 0, 0, 0, 1}),
          matrix_text("projection_matrix", 3, 4, {fx, 0, cx, 0, 0, fy, cy, 0, 0, 0, 1, 0})));
}

/// [m] by the laser's index: the worst of the depths that were seen; 0 if it was not calibrated.
std::vector<double> found_deviations(const Calibration& calibration) {
  constexpr double kMetres = 1e-3;
  constexpr double kUnknown = std::numeric_limits<double>::infinity();
  std::vector<double> deviations(calibration.scanner.lasers.size());
  for (const PointUncertainty& point : calibration.uncertainty) {
    double& deviation = deviations.at(scan_cell_common::laser_index(point.laser));
    const double found = kMetres * point.deviation_mm;
    deviation = std::max(deviation, std::isnan(found) ? kUnknown : found);
  }
  return deviations;
}

/// [m] standard deviation of a scanned point from all that it depends on, by the laser's index; 0:
/// not known. With a kept camera, a laser that was not calibrated again is as uncertain as before.
/// A laser that was has the share of its new plane and that of camera and hand-eye. The file gives
/// the latter only together with a plane, so the worst of its figures is taken: rather too large
/// than too small.
std::vector<double> point_deviations(const CalibrationRun& run) {
  const std::vector<std::string>& kept = run.calibration->kept;
  const auto is_kept = [&kept](const std::string& part) {
    return std::find(kept.begin(), kept.end(), part) != kept.end();
  };
  std::vector<double> deviations = found_deviations(*run.calibration);
  if (run.existing && is_kept("camera")) {
    std::vector<double> before = run.existing->deviations;
    before.resize(std::max(before.size(), deviations.size()));
    const double camera = *std::max_element(before.begin(), before.end());
    for (std::size_t i = 0; i < deviations.size(); ++i) {
      const double again = camera > 0 ? std::hypot(deviations[i], camera) : 0;
      deviations[i] = is_kept(scan_cell_common::laser_name(i)) ? before[i] : again;
    }
  }
  for (double& deviation : deviations)
    if (deviation > scan_cell_common::kMaxPointDeviation) deviation = 0;
  return deviations;
}

void save_scanner(const CalibrationRun& run, const std::string& path) {
  std::vector<double> deviations = point_deviations(run);
  if (std::all_of(deviations.begin(), deviations.end(), [](double each) { return each == 0; }))
    deviations.clear();
  scan_cell_common::save_scanner_model(path, run.calibration->scanner,
                                       run.existing ? run.existing->text : "", deviations);
}

}  // namespace

std::string camera_info_file(const std::string& scanner) {
  return with_stem(scanner, "_camera_info");
}

void check_writable(const CalibrationFiles& files) {
  std::set<std::string> names;
  for (const std::string& file : {files.scanner, files.camera_info, files.report}) {
    const fs::path folder = fs::absolute(file).parent_path();
    if (!fs::is_directory(folder))
      throw scan_cell_common::FileError(folder.string(), "no such folder", "create it");
    if (!names.insert(fs::absolute(file).lexically_normal().string()).second)
      throw scan_cell_common::FileError(file, "named twice", "give each result its own file");
  }
}

WrittenFiles save_calibration(const CalibrationRun& run, const CalibrationFiles& files) {
  WrittenFiles written;
  written.report = files.report;
  written.page = fs::path(files.report).replace_extension(".html").string();
  if (run.verdict == CalibrationVerdict::kPassed) {
    written.kept_scanner = keep_old(files.scanner);
    keep_old(files.camera_info);
    save_camera_info(files.camera_info, run.calibration->scanner.camera);
    save_scanner(run, files.scanner);
    written.scanner = files.scanner;
    written.camera_info = files.camera_info;
  }
  scan_cell_common::save_text(written.page, report_page(run, written));
  scan_cell_common::save_text(written.report, report_json(run, written));
  return written;
}

}  // namespace scan_calibration
