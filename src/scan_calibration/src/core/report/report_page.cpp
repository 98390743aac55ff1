// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <map>

#include "report/html.h"
#include "scan_calibration/calibration_files.h"

namespace scan_calibration {
namespace {

using Cells = std::vector<std::string>;
using Rows = std::vector<Cells>;

std::string list(const std::vector<std::string>& lines) {
  std::string text = "<ul>\n";
  for (const std::string& line : lines)
    text += "<li>" + escaped(line) + "</li>\n";
  return text + "</ul>\n";
}

std::string verdict(const CalibrationRun& run, const WrittenFiles& written) {
  std::string text;
  switch (run.verdict) {
    case CalibrationVerdict::PASSED:
      text = run.judged.empty() ? "<p class=\"passed\"><b>Calibrated.</b> No limits were given."
                                : "<p class=\"passed\"><b>Passed.</b>";
      text += " Written: " + escaped(written.scanner) + ".";
      if (!written.kept_scanner.empty())
        text += " The old model is kept as " + escaped(written.kept_scanner) + ".";
      break;
    case CalibrationVerdict::LIMITS_MISSED:
      text = "<p class=\"failed\"><b>Not accepted:</b> a limit is missed. No model was written.";
      break;
    case CalibrationVerdict::REFUSED:
      text =
          "<p class=\"failed\"><b>Refused:</b> " + escaped(run.reason) + ". No model was written.";
  }
  text += "</p>\n";
  if (run.judged.empty()) return text;
  Rows rows;
  for (const JudgedFigure& figure : run.judged) {
    rows.push_back({escaped(figure.name), rounded(figure.value, 3), rounded(figure.limit, 3),
                    figure.passed() ? "<span class=\"passed\">passed</span>"
                                    : "<span class=\"failed\">missed</span>"});
  }
  return text + html_table({"limit, on views that were not fitted", "value", "limit", ""}, rows);
}

/// What is calibrated anew, and what is not.
std::string parts(const CalibrationRun& run) {
  const auto& kept = run.calibration->kept;
  if (!run.existing || kept.empty()) return {};
  std::string text = "<p>Not calibrated anew, kept from " + escaped(run.existing->file) + ":";
  for (std::size_t i = 0; i < kept.size(); ++i)
    text += (i == 0 ? " " : ", ") + escaped(kept[i]);
  return text + ".</p>\n";
}

std::string figures(const CalibrationRun& run) {
  const std::vector<std::string>& lasers = run.observations.lasers;
  const auto row = [&](const std::string& name, const auto& value) {
    Cells cells = {escaped(name), rounded(value(run.calibration->fitted), 3),
                   rounded(value(run.calibration->held_out), 3)};
    if (!run.sequential) return cells;
    cells.push_back(rounded(value(run.sequential->fitted), 3));
    cells.push_back(rounded(value(run.sequential->held_out), 3));
    return cells;
  };
  Rows rows = {row("reprojection [px RMS]",
                   [](const Figures& figures) { return figures.reprojection_rms_px; })};
  for (std::size_t i = 0; i < lasers.size(); ++i) {
    rows.push_back(row("plane of " + lasers[i] + " [mm RMS]",
                       [i](const Figures& figures) { return figures.laser_plane_rms_mm.at(i); }));
  }
  rows.push_back(row("scatter of the board's centre [mm RMS]",
                     [](const Figures& figures) { return figures.board_scatter_mm; }));
  Cells header = {"", "fitted", "held out"};
  if (run.sequential) header.insert(header.end(), {"one after the other, fitted", "held out"});
  return "<h2>How well the views agree</h2>\n<p>Held out: each view judged by a model that was "
         "fitted without it. That is the figure to believe.</p>\n" +
         html_table(header, rows);
}

std::string uncertainty(const Calibration& calibration) {
  Rows rows;
  for (const PointUncertainty& point : calibration.uncertainty) {
    rows.push_back({escaped(point.laser), rounded(point.depth * 1e3, 0),
                    rounded(point.pixel.x(), 0) + ", " + rounded(point.pixel.y(), 0),
                    rounded(point.deviation_mm, 3)});
  }
  return "<h2>What that means for a scanned point</h2>\n<p>One standard deviation of a point's "
         "place in tool0 that comes from the calibration alone.</p>\n" +
         html_table({"laser", "depth [mm]", "seen at [px]", "deviation [mm]"}, rows);
}

std::string parameters(const Calibration& calibration) {
  Rows rows;
  for (const EstimatedParameter& parameter : calibration.parameters) {
    rows.push_back({escaped(parameter.name), rounded(parameter.value, 6),
                    rounded(parameter.deviation, 6), escaped(parameter.unit)});
  }
  return "<h2>Parameters</h2>\n<p>The covariance is in the JSON report.</p>\n" +
         html_table({"", "value", "standard deviation", "unit"}, rows);
}

std::string views(const CalibrationRun& run) {
  const std::vector<std::string>& lasers = run.observations.lasers;
  std::map<std::string, const ViewObservation*> seen;
  for (const ViewObservation& view : run.observations.views)
    seen[view.name] = &view;
  Cells header = {"view", "corners", "reprojection [px]"};
  for (const std::string& laser : lasers)
    header.insert(header.end(), {laser + " points", "off plane [mm]"});
  header.insert(header.end(), {"board off [mm]", "[deg]"});
  Rows rows;
  for (const ViewFigures& view : run.calibration->views) {
    const ViewObservation& what = *seen.at(view.name);
    Cells cells = {escaped(view.name),
                   std::to_string(what.corners.size() - view.left_out_corners.size()),
                   rounded(view.reprojection_rms_px, 3)};
    for (std::size_t i = 0; i < lasers.size(); ++i) {
      cells.push_back(std::to_string(what.lines[i].size()));
      cells.push_back(rounded(view.laser_plane_rms_mm.at(i), 3));
    }
    cells.push_back(rounded(view.board_offset_mm, 3));
    cells.push_back(rounded(view.board_angle_deg, 3));
    rows.push_back(cells);
  }
  return "<h2>Views</h2>\n" + html_table(header, rows);
}

std::string rejected(const std::vector<RejectedView>& views) {
  if (views.empty()) return {};
  Rows rows;
  for (const RejectedView& view : views)
    rows.push_back({escaped(view.name), view.laser.empty() ? "the view" : escaped(view.laser),
                    escaped(view.reason)});
  return "<h2>Not used</h2>\n" + html_table({"view", "what", "why"}, rows);
}

std::string advice(const Calibration& calibration) {
  std::string text;
  if (!calibration.notes.empty()) text += "<h2>Mind</h2>\n" + list(calibration.notes);
  if (calibration.advice.empty()) return text;
  std::vector<std::string> lines;
  for (const PoseAdvice& pose : calibration.advice)
    lines.push_back(pose.text);
  return text + "<h2>Poses to add next</h2>\n" + list(lines);
}

std::string shown(const std::vector<ReportPicture>& pictures) {
  std::string text;
  for (const ReportPicture& picture : pictures) {
    text += "<figure><img src=\"" + escaped(picture.file) + "\" alt=\"" + escaped(picture.name) +
            "\"><figcaption>" + escaped(picture.caption) + "</figcaption></figure>\n";
  }
  return text;
}

}  // namespace

std::string report_page(const CalibrationRun& run, const WrittenFiles& written,
                        const std::vector<ReportPicture>& pictures) {
  std::string body = verdict(run, written);
  body += "<p>Session " + escaped(run.session) + ": " + std::to_string(run.taken) + " views, " +
          std::to_string(run.calibration ? run.calibration->views.size() : 0) + " used.</p>\n";
  if (!run.calibration) {
    body += shown(pictures) + rejected(run.observations.rejected);
    return html_page("Calibration", body);
  }
  const Calibration& calibration = *run.calibration;
  body += parts(run) + figures(run) + uncertainty(calibration) + advice(calibration) +
          "<h2>Pictures</h2>\n" + shown(pictures) + parameters(calibration) + views(run) +
          rejected(calibration.rejected);
  return html_page("Calibration", body);
}

}  // namespace scan_calibration
