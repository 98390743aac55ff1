// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "report/html.h"
#include "report/report.h"

namespace scan_calibration {
namespace {

using Cells = std::vector<std::string>;
using Rows = std::vector<Cells>;

std::string list(const std::string& title, const std::vector<std::string>& lines) {
  if (lines.empty()) return {};
  std::string items;
  for (const std::string& line : lines)
    items += fmt::format("<li>{}</li>\n", escaped(line));
  return fmt::format("<h2>{}</h2>\n<ul>\n{}</ul>\n", title, items);
}

std::string verdict(const CalibrationRun& run, const WrittenFiles& written) {
  switch (run.verdict) {
    case CalibrationVerdict::kPassed: {
      const char* const what =
          run.judged.empty() ? "<b>Calibrated.</b> No limits were given." : "<b>Passed.</b>";
      const std::string kept =
          written.kept_scanner.empty()
              ? ""
              : fmt::format(" The old model is kept as {}.", escaped(written.kept_scanner));
      return fmt::format("<p class=\"passed\">{} Written: {}.{}</p>\n", what,
                         escaped(written.scanner), kept);
    }
    case CalibrationVerdict::kLimitsMissed:
      return "<p class=\"failed\"><b>Not accepted:</b> a limit is missed. No model was "
             "written.</p>\n";
    case CalibrationVerdict::kRefused:
      break;
  }
  return fmt::format("<p class=\"failed\"><b>Refused:</b> {}. No model was written.</p>\n",
                     escaped(run.reason));
}

std::string limits(const std::vector<JudgedFigure>& judged) {
  if (judged.empty()) return {};
  Rows rows;
  Cells classes;
  for (const JudgedFigure& figure : judged) {
    classes.emplace_back(figure.passed() ? "passed" : "failed");
    rows.push_back({figure.name, rounded(figure.value, 3), rounded(figure.limit, 3),
                    figure.passed() ? "passed" : "missed"});
  }
  return html_table({"limit, on held-out views", "value", "limit", ""}, rows, classes);
}

std::string kept_parts(const CalibrationRun& run) {
  const std::vector<std::string>& kept = run.calibration->kept;
  if (!run.existing || kept.empty()) return {};
  return fmt::format("<p>Not calibrated again, kept from {}: {}.</p>\n",
                     escaped(run.existing->file),
                     escaped(fmt::format("{}", fmt::join(kept, ", "))));
}

std::string figures(const CalibrationRun& run) {
  const std::vector<std::string>& lasers = run.observations.lasers;
  const auto row = [&](const std::string& name, const auto& value) {
    Cells cells = {name, rounded(value(run.calibration->fitted), 3),
                   rounded(value(run.calibration->held_out), 3)};
    if (!run.sequential) return cells;
    cells.push_back(rounded(value(run.sequential->fitted), 3));
    cells.push_back(rounded(value(run.sequential->held_out), 3));
    return cells;
  };
  Rows rows = {
      row("reprojection [px RMS]", [](const Figures& f) { return f.reprojection_rms_px; })};
  for (std::size_t i = 0; i < lasers.size(); ++i)
    rows.push_back(row(fmt::format("plane of {} [mm RMS]", lasers[i]),
                       [i](const Figures& f) { return f.laser_plane_rms_mm.at(i); }));
  rows.push_back(row("scatter of the board's centre [mm RMS]",
                     [](const Figures& f) { return f.board_scatter_mm; }));
  Cells header = {"", "fitted", "held out"};
  if (run.sequential) header.insert(header.end(), {"step by step, fitted", "held out"});
  return "<h2>Agreement of the views</h2>\n<p>Held out: each view is judged by a model that was "
         "fitted without it. Rely on this figure.</p>\n" +
         html_table(header, rows);
}

std::string uncertainty(const Calibration& calibration) {
  Rows rows;
  for (const PointUncertainty& point : calibration.uncertainty)
    rows.push_back({point.laser, rounded(point.depth * 1e3, 0),
                    fmt::format("{:.0f}, {:.0f}", point.pixel.x(), point.pixel.y()),
                    rounded(point.deviation_mm, 3)});
  return "<h2>Uncertainty of a scanned point</h2>\n<p>One standard deviation of a point in tool0, "
         "from the calibration alone.</p>\n" +
         html_table({"laser", "depth [mm]", "seen at [px]", "deviation [mm]"}, rows);
}

std::string parameters(const Calibration& calibration) {
  Rows rows;
  for (const EstimatedParameter& parameter : calibration.parameters)
    rows.push_back({parameter.name, rounded(parameter.value, 6), rounded(parameter.deviation, 6),
                    parameter.unit});
  return "<h2>Parameters</h2>\n<p>The covariance is in the JSON report.</p>\n" +
         html_table({"", "value", "standard deviation", "unit"}, rows);
}

std::string views(const CalibrationRun& run) {
  const std::vector<std::string>& lasers = run.observations.lasers;
  const ViewsByName seen = by_name(run.observations);
  Cells header = {"view", "corners", "reprojection [px]"};
  for (const std::string& laser : lasers)
    header.insert(header.end(), {laser + " points", "off plane [mm]"});
  header.insert(header.end(), {"board off [mm]", "[deg]"});
  Rows rows;
  for (const ViewFigures& view : run.calibration->views) {
    const ViewObservation& observed = *seen.at(view.name);
    Cells cells = {view.name,
                   std::to_string(observed.corners.size() - view.left_out_corners.size()),
                   rounded(view.reprojection_rms_px, 3)};
    for (std::size_t i = 0; i < lasers.size(); ++i) {
      cells.push_back(std::to_string(observed.lines[i].size()));
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
    rows.push_back({view.name, view.laser.empty() ? "the view" : view.laser, view.reason});
  return "<h2>Not used</h2>\n" + html_table({"view", "what", "why"}, rows);
}

std::string advice(const Calibration& calibration) {
  std::vector<std::string> poses;
  for (const PoseAdvice& pose : calibration.advice)
    poses.push_back(pose.text);
  return list("Notes", calibration.notes) + list("Poses to add next", poses);
}

std::string pictures(const CalibrationRun& run) {
  std::string text;
  for (const ReportPicture& picture : report_pictures(run))
    text += fmt::format("<figure id=\"{}\">\n{}<figcaption>{}</figcaption></figure>\n",
                        escaped(picture.name), picture.svg, escaped(picture.caption));
  return text;
}

}  // namespace

std::string report_page(const CalibrationRun& run, const WrittenFiles& written) {
  std::string body = verdict(run, written) + limits(run.judged);
  body += fmt::format("<p>Session {}: {} views, {} used.</p>\n", escaped(run.session), run.taken,
                      run.calibration ? run.calibration->views.size() : 0);
  if (!run.calibration)
    return html_page("Calibration", body + pictures(run) + rejected(run.observations.rejected));
  const Calibration& calibration = *run.calibration;
  return html_page("Calibration", body + kept_parts(run) + figures(run) + uncertainty(calibration) +
                                      advice(calibration) + "<h2>Pictures</h2>\n" + pictures(run) +
                                      parameters(calibration) + views(run) +
                                      rejected(calibration.rejected));
}

}  // namespace scan_calibration
