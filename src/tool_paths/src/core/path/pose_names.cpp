// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "path/pose_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "path/name_parts.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/errors/text.h"
#include "scan_cell_common/pose/euler_angles.h"
#include "scan_cell_common/pose/units.h"

namespace tool_paths {
namespace {

using scan_cell_common::excerpt;
using scan_cell_common::InvalidParameter;
using scan_cell_common::UnusableInput;
using Kind = OrientationNames::Kind;

using Indices = std::vector<std::size_t>;

class Reader {
 public:
  Reader(const std::vector<std::string>& names, const PathConventions& conventions,
         const std::string& where)
      : names_(names), conventions_(conventions), where_(where), taken_(names.size(), false) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      parts_.push_back(parts_of(names[i]));
      places_[parts_.back().base].push_back(i);
    }
  }

  PoseNames read() {
    const Indices process = declared_process_values();
    read_position();
    read_orientation();
    for (std::size_t i = 0; i < names_.size(); ++i) {
      if (taken_[i]) continue;
      if (could_be_orientation(names_[i])) refuse_unknown({i});
      found_.process.push_back(i);
    }
    refuse_triples();
    for (const std::size_t i : process)
      found_.process.push_back(i);
    std::sort(found_.process.begin(), found_.process.end());
    return std::move(found_);
  }

 private:
  std::string quoted(const Indices& indices) const {
    std::string text;
    for (const std::size_t i : indices)
      text += (text.empty() ? "'" : ", '") + excerpt(names_[i]) + "'";
    return text;
  }

  [[noreturn]] void refuse_unknown(const Indices& indices) const {
    std::string list;
    for (const std::size_t i : indices)
      list += (list.empty() ? "" : ",") + excerpt(names_[i]);
    throw UnusableInput(
        where_, quoted(indices) + " could be an orientation, but its kind is not given",
        fmt::format("say how angles turn (--euler zyx --degrees, or --rotation-vector --radians), "
                    "name quaternions qx,qy,qz,qw and tool vectors i,j,k, or say that it is not "
                    "one (--process-values {})",
                    list));
  }

  /// Names that the user declared as process values.
  Indices declared_process_values() {
    Indices found;
    for (const std::string& name : conventions_.process_values) {
      const auto at = std::find(names_.begin(), names_.end(), name);
      if (at == names_.end()) {
        throw InvalidParameter("process values",
                               fmt::format("'{}' is not in the tool path", excerpt(name)),
                               "give names that are in " + where_);
      }
      found.push_back(static_cast<std::size_t>(at - names_.begin()));
      take(found.back());
    }
    return found;
  }

  void take(std::size_t i) { taken_[i] = true; }

  /// The unused names of a group, with units of one kind; none unless all are there.
  template <class IsUnit>
  std::optional<Indices> find(const std::vector<std::string>& group, const IsUnit& is_unit) const {
    Indices found;
    for (const std::string& base : group) {
      const auto places = places_.find(base);
      if (places == places_.end()) return {};
      const auto fits = [&](std::size_t i) {
        return !taken_[i] && (parts_[i].unit.empty() || is_unit(parts_[i].unit));
      };
      const auto at = std::find_if(places->second.begin(), places->second.end(), fits);
      if (at == places->second.end()) return {};
      if (std::any_of(at + 1, places->second.end(), fits)) {
        throw UnusableInput(where_, quoted(places->second) + " have the same meaning", "keep one");
      }
      found.push_back(*at);
    }
    return found;
  }

  /// The unit common to all of these names; empty if none has one.
  std::string unit_of(const Indices& indices) const {
    const std::string unit = parts_[indices[0]].unit;
    for (const std::size_t i : indices) {
      if (parts_[i].unit == unit) continue;
      throw UnusableInput(where_, quoted(indices) + " have different units", "use one unit");
    }
    return unit;
  }

  void read_position() {
    for (const char* const axis : {"x", "y", "z"}) {
      if (!find({axis}, is_length_unit)) {
        throw UnusableInput(where_, fmt::format("no column '{}'", axis),
                            "name the position x,y,z: begin a CSV file with the header "
                            "x,y,z[,qx,qy,qz,qw]");
      }
    }
    const Indices found = *find({"x", "y", "z"}, is_length_unit);
    PoseConvention& convention = found_.convention;
    const std::string unit = unit_of(found);
    if (!unit.empty() && !conventions_.units.empty() && unit != conventions_.units) {
      throw InvalidParameter(
          "units of the tool path",
          fmt::format("'{}', but the path has {}", conventions_.units, quoted(found)),
          "leave them out, or give " + unit);
    }
    if (!unit.empty() || !conventions_.units.empty())
      convention.units = unit.empty() ? conventions_.units : unit;
    for (std::size_t i = 0; i < 3; ++i) {
      found_.position[i] = found[i];
      convention.position[i] = names_[found[i]];
      take(found[i]);
    }
  }

  void read_orientation() {
    std::optional<Indices> found;
    const OrientationNames* group = nullptr;
    for (const OrientationNames& each : known_orientation_names()) {
      const bool angles = each.kind == Kind::kAnglesByAxis || each.kind == Kind::kAnglesByTurn;
      const auto is_unit = [angles](const std::string& unit) {
        return angles && is_angle_unit(unit);
      };
      const std::optional<Indices> there = find(each.names, is_unit);
      if (!there) {
        if (each.kind == Kind::kQuaternion) refuse_half_a_quaternion(each.names);
        continue;
      }
      if (found) {
        throw UnusableInput(
            where_, fmt::format("two orientations: {} and {}", quoted(*found), quoted(*there)),
            "keep one, or say which is not one (--process-values)");
      }
      found = there;
      group = &each;
    }
    if (group == nullptr) return refuse_idle_conventions();
    found_.orientation = *found;
    if (group->kind == Kind::kAnglesByAxis || group->kind == Kind::kAnglesByTurn) {
      read_angles(*group);
    } else {
      refuse_idle_conventions();
      found_.convention.orientation = group->kind == Kind::kVector ? OrientationKind::kToolVector
                                                                   : OrientationKind::kQuaternion;
    }
    for (const std::size_t i : found_.orientation) {
      found_.convention.names.push_back(names_[i]);
      take(i);
    }
  }

  void refuse_half_a_quaternion(const std::vector<std::string>& names) const {
    if (names[0] != "qx") return;
    const auto is_there = [this](const std::string& name) { return places_.count(name) > 0; };
    if (std::none_of(names.begin(), names.end(), is_there)) return;
    throw UnusableInput(where_, "only some of the columns qx,qy,qz,qw", "give all four or none");
  }

  /// A convention for angles without any angles was meant for something else.
  void refuse_idle_conventions() const {
    const bool said = !conventions_.euler.empty() || conventions_.rotation_vector ||
                      conventions_.angles != AngleUnit::kNotGiven;
    if (!said) return;
    throw InvalidParameter("angles of the tool path", "there are none in " + where_,
                           "leave out --euler, --rotation-vector, --degrees and --radians, or name "
                           "the angles rx,ry,rz");
  }

  void read_angles(const OrientationNames& group) {
    PoseConvention& convention = found_.convention;
    const Indices& found = found_.orientation;
    const std::string unit = unit_of(found);
    const bool comau = group.names == std::vector<std::string>{"a", "e", "r"};
    if (conventions_.rotation_vector) return read_rotation_vector(group, unit);
    convention.euler = conventions_.euler;
    if (comau && unit == "deg" && convention.euler.empty()) convention.euler = "zyz";
    if (convention.euler.empty()) refuse_unknown(found);
    if (comau && convention.euler != "zyz") {
      throw InvalidParameter("euler",
                             fmt::format("'{}' for {}", excerpt(convention.euler), quoted(found)),
                             "give zyz: Comau turns A, E and R that way");
    }
    convention.degrees = is_in_degrees(unit);
    convention.orientation = OrientationKind::kEuler;
    const scan_cell_common::EulerSequence sequence(convention.euler);
    convention.euler = sequence.axes();
    if (group.kind == Kind::kAnglesByTurn) return;
    if (sequence.repeats()) {
      throw InvalidParameter("euler", fmt::format("'{}' for {}", convention.euler, quoted(found)),
                             "give a sequence of three different axes, such as zyx");
    }
    const Indices by_axis = found;
    for (std::size_t turn = 0; turn < 3; ++turn) {
      found_.orientation[turn] = by_axis[static_cast<std::size_t>(convention.euler[turn] - 'x')];
    }
  }

  void read_rotation_vector(const OrientationNames& group, const std::string& unit) {
    if (!conventions_.euler.empty()) {
      throw InvalidParameter("rotation-vector", "given together with --euler", "give one of them");
    }
    if (group.kind != Kind::kAnglesByAxis) {
      throw InvalidParameter("rotation-vector", "given for " + quoted(found_.orientation),
                             "name its parts rx,ry,rz");
    }
    found_.convention.orientation = OrientationKind::kRotationVector;
    found_.convention.degrees = is_in_degrees(unit);
  }

  bool is_in_degrees(const std::string& unit) const {
    const AngleUnit said = conventions_.angles;
    if (unit.empty() && said == AngleUnit::kNotGiven) {
      throw UnusableInput(where_, quoted(found_.orientation) + " are angles without a unit",
                          "give --degrees or --radians");
    }
    if (unit.empty()) return said == AngleUnit::kDegrees;
    const bool degrees = unit == "deg";
    if (said != AngleUnit::kNotGiven && degrees != (said == AngleUnit::kDegrees)) {
      throw InvalidParameter("unit of the angles", "not that of " + quoted(found_.orientation),
                             "leave out --degrees and --radians");
    }
    return degrees;
  }

  /// Three names that differ only in x, y and z are a vector, which would have to rotate.
  void refuse_triples() const {
    std::map<std::string, std::array<Indices, 3>> patterns;
    for (const std::size_t i : found_.process) {
      const std::string& base = parts_[i].base;
      for (std::size_t at = 0; at < base.size(); ++at) {
        if (base[at] < 'x' || base[at] > 'z') continue;
        std::string pattern = base;
        pattern[at] = '?';
        patterns[pattern][static_cast<std::size_t>(base[at] - 'x')].push_back(i);
      }
    }
    for (const auto& [pattern, axes] : patterns) {
      if (axes[0].empty() || axes[1].empty() || axes[2].empty()) continue;
      refuse_unknown({axes[0][0], axes[1][0], axes[2][0]});
    }
  }

  const std::vector<std::string>& names_;
  const PathConventions& conventions_;
  const std::string& where_;
  std::vector<NameParts> parts_;
  std::map<std::string, Indices> places_;
  std::vector<bool> taken_;
  PoseNames found_;
};

}  // namespace

PoseNames understand(const std::vector<std::string>& names, const PathConventions& conventions,
                     const std::string& where) {
  if (!conventions.units.empty()) scan_cell_common::metres_per(conventions.units);
  return Reader(names, conventions, where).read();
}

}  // namespace tool_paths
