// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tool_path_programs/read_back.h"

#include <fmt/format.h>

#include <cmath>

#include "scan_cell_common/errors/errors.h"

namespace tool_path_programs {
namespace {

class Comparison {
 public:
  Comparison(const Unsaid& unsaid, const ReadBackLimits& limits)
      : unsaid_(unsaid), limits_(limits) {}

  /// Empty: no difference.
  std::string operator()(const Step& meant, const Step& read) const {
    if (meant.index() != read.index()) return "another kind of step";
    if (const Move* move = std::get_if<Move>(&meant)) return moves(*move, std::get<Move>(read));
    if (const SetOutput* output = std::get_if<SetOutput>(&meant))
      return outputs(*output, std::get<SetOutput>(read));
    return std::get<JointMove>(meant).joints == std::get<JointMove>(read).joints
               ? ""
               : "other angles of the axes";
  }

 private:
  std::string moves(const Move& meant, const Move& read) const {
    if (meant.kind != read.kind) return "another kind of motion";
    if (meant.via.has_value() != read.via.has_value()) return "with and without via";
    std::string fault = poses(meant.pose, read.pose);
    if (fault.empty() && meant.via) fault = poses(*meant.via, *read.via);
    if (fault.empty()) fault = speeds(meant, read);
    if (fault.empty() && !unsaid_.zones && std::abs(meant.zone - read.zone) > limits_.zone)
      fault = fmt::format("zone {:.6g} mm instead of {:.6g} mm", 1e3 * read.zone, 1e3 * meant.zone);
    return fault;
  }

  std::string poses(const Eigen::Isometry3d& meant, const Eigen::Isometry3d& read) const {
    const double distance = (meant.translation() - read.translation()).norm();
    if (!(distance <= limits_.position))
      return fmt::format("position {:.3g} mm off", 1e3 * distance);
    const double angle =
        Eigen::Quaterniond(meant.linear()).angularDistance(Eigen::Quaterniond(read.linear()));
    if (!unsaid_.orientations && !(angle <= limits_.angle))
      return fmt::format("turned by {:.3g} degrees", angle * 180 / M_PI);
    return "";
  }

  std::string speeds(const Move& meant, const Move& read) const {
    const bool joint = meant.kind == MotionKind::kJoint;
    const double wanted = joint ? meant.joint_speed : meant.speed;
    const double got = joint ? read.joint_speed : read.speed;
    if (std::abs(got - wanted) <= limits_.speed * wanted * (1 + 1e-9) + 1e-12) return "";
    return joint ? fmt::format("{:.6g} % of the axes' speed instead of {:.6g} %", 100 * got,
                               100 * wanted)
                 : fmt::format("{:.6g} mm/s instead of {:.6g} mm/s", 1e3 * got, 1e3 * wanted);
  }

  static std::string outputs(const SetOutput& meant, const SetOutput& read) {
    if (meant.output == read.output && meant.on == read.on) return "";
    return fmt::format("output {} {} instead of {} {}", read.output, read.on ? "on" : "off",
                       meant.output, meant.on ? "on" : "off");
  }

  const Unsaid& unsaid_;
  const ReadBackLimits& limits_;
};

}  // namespace

std::string first_difference(const Program& meant, const Program& read, const Unsaid& unsaid,
                             const ReadBackLimits& limits) {
  const Comparison compare(unsaid, limits);
  std::size_t waypoint = 0;
  for (std::size_t i = 0; i < meant.steps.size() && i < read.steps.size(); ++i) {
    waypoint += std::holds_alternative<Move>(meant.steps[i]) ? 1 : 0;
    const std::string fault = compare(meant.steps[i], read.steps[i]);
    if (!fault.empty()) return fmt::format("step {}, waypoint {}: {}", i + 1, waypoint, fault);
  }
  if (meant.steps.size() == read.steps.size()) return "";
  return fmt::format("{} steps instead of {}", read.steps.size(), meant.steps.size());
}

WrittenProgram write_checked(const Language& language, const Program& program,
                             const WriteSettings& settings, const ReadSettings& known) {
  WrittenProgram written = language.write(program, settings);
  ReadSettings read_settings = known;
  read_settings.dialect = settings.dialect;
  const ProgramText read = language.read(written.files, read_settings);
  ReadBackLimits limits;
  limits.speed = settings.max_speed_change;
  const std::string difference =
      first_difference(program, read.program, language.unsaid(settings), limits);
  if (!difference.empty())
    throw scan_cell_common::UnusableInput(language.title() + " program " + program.name,
                                          "it differs when read back: " + difference,
                                          "nothing was written; please report this with the path");
  return written;
}

}  // namespace tool_path_programs
