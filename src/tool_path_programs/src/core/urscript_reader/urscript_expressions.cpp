// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "urscript_reader/urscript_expressions.h"

#include <cmath>

#include "scan_cell_common/errors/text.h"
#include "text/rotation_vector.h"

namespace tool_path_programs {
namespace {

using Kind = ScriptValue::Kind;

constexpr std::size_t kDeepestBrackets = 50;
constexpr double kFarthest = 1000;  // [m]
constexpr double kWidest = 100;     // [rad]

ScriptValue number_value(double number) {
  ScriptValue value;
  if (!std::isfinite(number)) return value;
  value.kind = Kind::kNumber;
  value.number = number;
  return value;
}

ScriptValue calculated(const ScriptValue& one, char operation, const ScriptValue& other) {
  if (!one.is(Kind::kNumber) || !other.is(Kind::kNumber)) return {};
  switch (operation) {
    case '+':
      return number_value(one.number + other.number);
    case '-':
      return number_value(one.number - other.number);
    case '*':
      return number_value(one.number * other.number);
    default:
      return number_value(one.number / other.number);
  }
}

/// A pose in a frame: pose_trans(frame, pose).
ScriptValue in_frame(const ScriptValue& frame, ScriptValue pose) {
  const bool is_frame = (frame.is(Kind::kPose) && !frame.user_literal && frame.user.name.empty()) ||
                        frame.is(Kind::kFree);
  if (!is_frame || !pose.is(Kind::kPose) || pose.user_literal || !pose.user.name.empty()) return {};
  pose.user.name = frame.name;
  if (frame.is(Kind::kPose)) {
    pose.user.pose = frame.pose.pose;
    pose.user_literal = frame.pose;
  }
  return pose;
}

}  // namespace

const ScriptValue* ScriptArguments::find(const std::string& name, std::size_t position) const {
  const auto at = named.find(name);
  if (at != named.end()) return &at->second;
  return position < positional.size() ? &positional[position] : nullptr;
}

ScriptValue ScriptExpressions::value() {
  if (++depth_ > kDeepestBrackets)
    reader_.fail("brackets nested too deeply", "split the expression");
  ScriptValue value = sum();
  if (!at_delimiter()) {
    value = ScriptValue();
    pass_rest();
  }
  --depth_;
  return value;
}

bool ScriptExpressions::at_delimiter() const {
  return reader_.at_line_end() || reader_.at_symbol(',') || reader_.at_symbol(')') ||
         reader_.at_symbol(']') || reader_.at_symbol(';') || reader_.at_symbol(':');
}

/// Skips an expression that only the controller can evaluate.
void ScriptExpressions::pass_rest() {
  std::size_t open = 0;
  while (!reader_.at_end() && (open > 0 || !at_delimiter())) {
    if (reader_.at_symbol('(') || reader_.at_symbol('[')) ++open;
    if (open > 0 && (reader_.at_symbol(')') || reader_.at_symbol(']'))) --open;
    reader_.next();
  }
}

/// Within brackets a line end counts as a blank.
void ScriptExpressions::pass_lines() {
  while (!reader_.at_end() && reader_.at_line_end())
    reader_.next();
}

ScriptValue ScriptExpressions::sum() {
  ScriptValue result = product();
  while (reader_.at_symbol('+') || reader_.at_symbol('-')) {
    const char operation = reader_.next().text.front();
    result = calculated(result, operation, product());
  }
  return result;
}

ScriptValue ScriptExpressions::product() {
  ScriptValue result = factor();
  while (reader_.at_symbol('*') || reader_.at_symbol('/')) {
    const char operation = reader_.next().text.front();
    result = calculated(result, operation, factor());
  }
  return result;
}

ScriptValue ScriptExpressions::factor() {
  bool minus = false;
  while (reader_.at_symbol('-') || reader_.at_symbol('+'))
    minus = (reader_.next().text.front() == '-') != minus;
  ScriptValue result;
  if (reader_.peek().kind == TokenKind::kNumber) {
    result = number_value(reader_.next().number);
  } else if (reader_.peek().kind == TokenKind::kName) {
    result = named();
  } else if (reader_.at_symbol('[')) {
    result = list();
  } else if (reader_.accept('(')) {
    pass_lines();
    result = value();
    pass_lines();
    reader_.expect(')');
  } else if (reader_.peek().kind == TokenKind::kText) {
    reader_.next();
  }
  return minus ? calculated(number_value(0), '-', result) : result;
}

ScriptValue ScriptExpressions::named() {
  const Place place = reader_.place();
  const std::size_t offset = reader_.peek().offset;
  const std::string name = reader_.name();
  if (name == "True" || name == "False") {
    ScriptValue truth = number_value(name == "True" ? 1 : 0);
    truth.kind = Kind::kTruth;
    return truth;
  }
  if (reader_.at_symbol('(')) return call(name);
  if (reader_.at_symbol('[')) return name == "p" ? pose(place, offset) : (list(), ScriptValue());
  if (name == "pi") return number_value(M_PI);
  return variables_.value(name);
}

ScriptValue ScriptExpressions::call(const std::string& function) {
  const ScriptArguments arguments = this->arguments();
  if (arguments.positional.empty()) return {};
  const ScriptValue& first = arguments.positional.front();
  if (function == "d2r") return calculated(first, '*', number_value(M_PI / 180));
  if (function == "r2d") return calculated(first, '*', number_value(180 / M_PI));
  if (function == "pose_trans" && arguments.positional.size() == 2)
    return in_frame(first, arguments.positional[1]);
  if (function == "get_inverse_kin" && first.is(Kind::kPose)) {
    ScriptValue result = first;
    const ScriptValue* near = arguments.find("qnear", 1);
    if (near != nullptr && near->is(Kind::kJoints)) result.joints = near->joints;
    return result;
  }
  return {};
}

ScriptArguments ScriptExpressions::arguments() {
  ScriptArguments arguments;
  reader_.expect('(');
  pass_lines();
  while (!reader_.at_symbol(')')) {
    const bool is_named =
        reader_.peek().kind == TokenKind::kName && reader_.peek_after().text == "=";
    std::string name;
    if (is_named) {
      name = reader_.name();
      reader_.expect('=');
    }
    ScriptValue argument = value();
    if (is_named)
      arguments.named[name] = std::move(argument);
    else
      arguments.positional.push_back(std::move(argument));
    pass_lines();
    if (!reader_.at_symbol(')')) reader_.expect(',');
    pass_lines();
  }
  reader_.expect(')');
  return arguments;
}

/// A list of numbers in brackets; none if one is computed.
/// @param plain for each: it is only a number with its sign
std::optional<std::vector<double>> ScriptExpressions::numbers(std::vector<bool>& plain) {
  std::vector<double> numbers;
  bool known = true;
  reader_.expect('[');
  pass_lines();
  while (!reader_.at_symbol(']')) {
    const std::size_t begin = reader_.position();
    const bool is_signed = reader_.at_symbol('-') || reader_.at_symbol('+');
    const TokenKind kind = (is_signed ? reader_.peek_after() : reader_.peek()).kind;
    const ScriptValue number = value();
    plain.push_back(kind == TokenKind::kNumber &&
                    reader_.position() == begin + (is_signed ? 2 : 1));
    known = known && number.is(Kind::kNumber);
    numbers.push_back(number.number);
    pass_lines();
    if (!reader_.at_symbol(']')) reader_.expect(',');
    pass_lines();
  }
  reader_.expect(']');
  if (!known) return std::nullopt;
  return numbers;
}

ScriptValue ScriptExpressions::list() {
  ScriptValue value;
  std::vector<bool> plain;
  const auto joints = numbers(plain);
  if (plain.size() != 6) return value;
  value.kind = Kind::kJoints;
  if (joints) value.joints = *joints;
  return value;
}

ScriptValue ScriptExpressions::pose(const Place& place, std::size_t offset) {
  std::vector<bool> plain;
  const std::size_t begin = reader_.position();
  const auto six = numbers(plain);
  if (plain.size() != 6) {
    reader_.go_to(begin);
    reader_.fail("a pose of " + std::to_string(plain.size()) + " numbers", "give six");
  }
  if (!six) return {};
  const Eigen::Map<const Eigen::Matrix<double, 6, 1>> numbers(six->data());
  if (numbers.head<3>().cwiseAbs().maxCoeff() > kFarthest ||
      numbers.tail<3>().cwiseAbs().maxCoeff() > kWidest) {
    reader_.go_to(begin);
    reader_.fail("a pose with numbers that are too large",
                 "give metres and a rotation vector in radians");
  }
  ScriptValue value;
  value.kind = Kind::kPose;
  value.pose.place = place;
  value.pose.offset = offset;
  for (const bool is_plain : plain)
    value.pose.has_numbers = value.pose.has_numbers && is_plain;
  value.pose.pose.translation() = numbers.head<3>();
  value.pose.pose.linear() = rotation_of(numbers.tail<3>());
  return value;
}

}  // namespace tool_path_programs
