// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <nlohmann/json.hpp>

#include "report/report.h"

namespace scan_calibration {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const Eigen::Isometry3d& pose) {
  const Eigen::Vector3d t = pose.translation();
  const Eigen::Quaterniond q(pose.linear());
  return {{"translation", {t.x(), t.y(), t.z()}}, {"rotation", {q.x(), q.y(), q.z(), q.w()}}};
}

Json by_laser(const std::vector<std::string>& lasers, const std::vector<double>& values) {
  Json result = Json::object();
  for (std::size_t i = 0; i < lasers.size() && i < values.size(); ++i)
    result[lasers[i]] = values[i];  // a NaN becomes null
  return result;
}

/// reprojection_rms_px, laser_plane_rms_mm by laser, board_scatter_mm; each fitted and held out.
void add_figures(Json& report, const std::vector<std::string>& lasers, const Figures& fitted,
                 const Figures& held_out) {
  const auto both = [](double a, double b) { return Json{{"fitted", a}, {"held_out", b}}; };
  report["reprojection_rms_px"] = both(fitted.reprojection_rms_px, held_out.reprojection_rms_px);
  report["laser_plane_rms_mm"] = Json::object();
  for (std::size_t i = 0; i < lasers.size(); ++i) {
    report["laser_plane_rms_mm"][lasers[i]] =
        both(fitted.laser_plane_rms_mm.at(i), held_out.laser_plane_rms_mm.at(i));
  }
  report["board_scatter_mm"] = both(fitted.board_scatter_mm, held_out.board_scatter_mm);
}

Json to_json(const LineCounts& counts) {
  return {{"peaks", counts.peaks},
          {"off_line", counts.off_line},
          {"at_edges", counts.at_edges},
          {"thinned", counts.thinned},
          {"used", counts.used}};
}

Json to_json(const ViewFigures& view, const ViewObservation& seen,
             const std::vector<std::string>& lasers) {
  Json result = {{"name", view.name},
                 {"reprojection_rms_px", view.reprojection_rms_px},
                 {"laser_plane_rms_mm", by_laser(lasers, view.laser_plane_rms_mm)},
                 {"board_offset_mm", view.board_offset_mm},
                 {"board_angle_deg", view.board_angle_deg},
                 {"corners", seen.corners.size()},
                 {"covered_corners", seen.covered_corners},
                 {"left_out_corners", view.left_out_corners.size()},
                 {"lines", Json::object()},
                 {"residuals_px", Json::array()}};
  for (std::size_t i = 0; i < seen.line_counts.size(); ++i)
    result["lines"][lasers[i]] = to_json(seen.line_counts[i]);
  for (std::size_t i = 0; i < seen.corners.size() && i < view.corner_residuals.size(); ++i) {
    const SeenCorner& corner = seen.corners[i];
    const Eigen::Vector2d& off = view.corner_residuals[i];
    result["residuals_px"].push_back(
        {corner.column, corner.row, corner.pixel.x(), corner.pixel.y(), off.x(), off.y()});
  }
  return result;
}

Json views_to_json(const CalibrationRun& run) {
  const ViewsByName seen = by_name(run.observations);
  Json result = Json::array();
  for (const ViewFigures& view : run.calibration->views)
    result.push_back(to_json(view, *seen.at(view.name), run.observations.lasers));
  return result;
}

Json rejected_to_json(const std::vector<RejectedView>& rejected) {
  Json result = Json::array();
  for (const RejectedView& view : rejected)
    result.push_back({{"view", view.name}, {"laser", view.laser}, {"reason", view.reason}});
  return result;
}

void add_verdict(Json& report, const CalibrationRun& run) {
  report["verdict"] = to_string(run.verdict);
  report["reason"] = run.reason;
  report["limits"] = Json::array();
  for (const JudgedFigure& figure : run.judged) {
    report["limits"].push_back({{"name", figure.name},
                                {"value", figure.value},
                                {"limit", figure.limit},
                                {"passed", figure.passed()}});
  }
}

void add_estimate(Json& report, const Calibration& calibration) {
  report["parameters"] = Json::array();
  for (const EstimatedParameter& parameter : calibration.parameters) {
    report["parameters"].push_back({{"name", parameter.name},
                                    {"unit", parameter.unit},
                                    {"value", parameter.value},
                                    {"deviation", parameter.deviation}});
  }
  report["covariance"] = Json::array();
  for (const auto& row : calibration.covariance.rowwise())
    report["covariance"].push_back(std::vector<double>(row.begin(), row.end()));
  report["base_to_board"] = to_json(calibration.base_to_board);
  const Eigen::Vector3d bend = calibration.board_bend * 1e3;
  report["board_bend_mm"] = {bend.x(), bend.y(), bend.z()};
  const NoiseLevels& noise = calibration.noise;
  report["noise"] = {{"corner_px", noise.corner_px},
                     {"line_px", noise.line_px},
                     {"robot_mm", noise.robot_m * 1e3},
                     {"robot_deg", noise.robot_rad * 180 / M_PI}};
  report["point_uncertainty"] = Json::array();
  for (const PointUncertainty& point : calibration.uncertainty) {
    report["point_uncertainty"].push_back({{"laser", point.laser},
                                           {"depth_m", point.depth},
                                           {"pixel", {point.pixel.x(), point.pixel.y()}},
                                           {"deviation_mm", point.deviation_mm}});
  }
  report["notes"] = calibration.notes;
  report["advice"] = Json::array();
  for (const PoseAdvice& advice : calibration.advice) {
    report["advice"].push_back({{"text", advice.text},
                                {"base_to_flange", to_json(advice.base_to_flange)},
                                {"deviation_mm", advice.deviation_mm}});
  }
}

}  // namespace

ViewsByName by_name(const Observations& observations) {
  ViewsByName result;
  for (const ViewObservation& view : observations.views)
    result[view.name] = &view;
  return result;
}

std::string report_json(const CalibrationRun& run, const WrittenFiles& written) {
  Json report;
  add_verdict(report, run);
  report["session"] = run.session;
  report["files"] = {{"scanner", written.scanner},
                     {"camera_info", written.camera_info},
                     {"kept_scanner", written.kept_scanner},
                     {"page", written.page}};
  if (run.existing) report["existing"] = run.existing->file;
  report["kept"] = run.calibration ? run.calibration->kept : std::vector<std::string>();
  report["views_taken"] = run.taken;
  report["views_used"] = run.calibration ? run.calibration->views.size() : 0;
  if (run.calibration) {
    const std::vector<std::string>& lasers = run.observations.lasers;
    add_figures(report, lasers, run.calibration->fitted, run.calibration->held_out);
    if (run.sequential)
      add_figures(report["sequential"], lasers, run.sequential->fitted, run.sequential->held_out);
    add_estimate(report, *run.calibration);
    report["views"] = views_to_json(run);
  }
  report["rejected"] =
      rejected_to_json(run.calibration ? run.calibration->rejected : run.observations.rejected);
  return report.dump(1) + "\n";
}

}  // namespace scan_calibration
