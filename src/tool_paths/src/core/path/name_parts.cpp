// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "path/name_parts.h"

#include <algorithm>
#include <map>
#include <set>

#include "path/pose_names.h"
#include "scan_cell_common/errors/text.h"

namespace tool_paths {
namespace {

const std::map<std::string, std::string>& units() {
  static const std::map<std::string, std::string> units = {
      {"m", "m"},         {"metres", "m"},       {"meters", "m"},      {"mm", "mm"},
      {"inch", "inch"},   {"inches", "inch"},    {"in", "inch"},       {"deg", "deg"},
      {"degree", "deg"},  {"degrees", "deg"},    {"rad", "rad"},       {"radian", "rad"},
      {"radians", "rad"}, {"millimetres", "mm"}, {"millimeters", "mm"}};
  return units;
}

bool is_one_of(char c, const std::string& characters) {
  return characters.find(c) != std::string::npos;
}

/// A letter and a number, as in r11, q0, j6, e2, or a letter and an axis, as in rx, oz.
bool is_numbered_part(const std::string& word) {
  constexpr std::size_t kLongest = 3;
  if (word.size() < 2 || word.size() > kLongest) return false;
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  const bool numbered = std::all_of(word.begin() + 1, word.end(), is_digit);
  if (numbered) return word.size() == 2 ? is_one_of(word[0], "qjr") : is_one_of(word[0], "rm");
  return word.size() == 2 && is_one_of(word[0], "rqon") && is_one_of(word[1], "xyzw");
}

/// Words that by themselves indicate an orientation.
const std::set<std::string>& plain_words() {
  static const std::set<std::string> words = {
      "roll",        "pitch",    "yaw",  "rpy",   "euler",  "quat",  "quaternion", "orient",
      "orientation", "rotation", "rot",  "angle", "angles", "tilt",  "heading",    "azimuth",
      "elevation",   "alpha",    "beta", "gamma", "phi",    "theta", "psi",        "rotvec"};
  return words;
}

/// Words that indicate an orientation if nothing else is named: a normal, but not a normal force.
const std::set<std::string>& hinting_words() {
  static const std::set<std::string> words = {
      "a",       "b",        "c",        "i",         "j",     "k",      "normal",
      "normals", "axis",     "axes",     "direction", "dir",   "vector", "vec",
      "tangent", "binormal", "approach", "matrix",    "joint", "joints"};
  return words;
}

const std::set<std::string>& neutral_words() {
  static const std::set<std::string> words = {"x", "y", "z", "w", "tool", "surface", "path", "tcp"};
  return words;
}

/// Whether a word is one of these, possibly followed by a number or an axis: angle1, rotx.
bool is_known(const std::string& word, const std::set<std::string>& words) {
  if (words.count(word) > 0) return true;
  constexpr std::size_t kShortest = 3;  // without the suffix: "bz" hints at nothing
  const std::size_t end = word.find_last_not_of("0123456789");
  std::string stem = word.substr(0, end == std::string::npos ? 0 : end + 1);
  if (stem == word && is_one_of(stem.back(), "xyzw")) stem.pop_back();
  return stem.size() >= kShortest && words.count(stem) > 0;
}

}  // namespace

NameParts parts_of(const std::string& name) {
  NameParts parts;
  std::string word;
  const auto flush = [&] {
    if (!word.empty()) parts.words.push_back(word);
    word.clear();
  };
  for (const char c : scan_cell_common::lower_case(name)) {
    if (is_one_of(c, " \t_-.,:/()[]{}<>")) {
      flush();
    } else {
      word += c;
    }
  }
  flush();
  std::size_t count = parts.words.size();
  if (count > 1) {
    const auto unit = units().find(parts.words.back());
    if (unit != units().end()) {
      parts.unit = unit->second;
      --count;
    }
  }
  for (std::size_t i = 0; i < count; ++i)
    parts.base += (i > 0 ? "_" : "") + parts.words[i];
  return parts;
}

const std::vector<OrientationNames>& known_orientation_names() {
  using Kind = OrientationNames::Kind;
  static const std::vector<OrientationNames> known = {
      {Kind::kQuaternion, {"qx", "qy", "qz", "qw"}},
      {Kind::kQuaternion, {"q2", "q3", "q4", "q1"}},  // ABB: q1 is the real part
      {Kind::kAnglesByAxis, {"rx", "ry", "rz"}},
      {Kind::kAnglesByAxis, {"rot_x", "rot_y", "rot_z"}},
      {Kind::kAnglesByAxis, {"rotx", "roty", "rotz"}},
      {Kind::kAnglesByAxis, {"roll", "pitch", "yaw"}},
      {Kind::kAnglesByAxis, {"w", "p", "r"}},  // Fanuc
      {Kind::kAnglesByTurn, {"a", "b", "c"}},  // Kuka
      {Kind::kAnglesByTurn, {"a", "e", "r"}},  // Comau
      {Kind::kAnglesByTurn, {"o", "a", "t"}},  // Kawasaki
      {Kind::kAnglesByTurn, {"alpha", "beta", "gamma"}},
      {Kind::kAnglesByTurn, {"phi", "theta", "psi"}},
      {Kind::kVector, {"i", "j", "k"}},
      {Kind::kVector, {"nx", "ny", "nz"}}};
  return known;
}

bool could_be_orientation(const std::string& name) {
  const NameParts parts = parts_of(name);
  if (is_angle_unit(parts.unit)) return true;
  bool hinted = false;
  bool of_something_else = false;
  for (const std::string& word : parts.words) {
    if (is_numbered_part(word) || is_known(word, plain_words())) return true;
    const bool hint = is_known(word, hinting_words());
    hinted = hinted || hint;
    of_something_else = of_something_else || (!hint && neutral_words().count(word) == 0);
  }
  return hinted && !of_something_else;
}

}  // namespace tool_paths
