// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace scan_cell_common {

/// What a number may be outside its range.
enum class Also { kNothing, kZero, kNone };  //!< kNone: infinite, which means no limit

/// One row of a table of parameters.
struct Parameter {
  std::string name;                     //!< with its groups: lookup/port
  std::string unit;                     //!< such as m; empty: none
  std::string meaning;                  //!< one plain line
  double min = 0;                       //!< of a number
  double max = 0;                       //!< of a number
  Also also = Also::kNothing;           //!< also allowed
  std::size_t count = 0;                //!< length of a list; 0: any
  std::vector<std::string> words = {};  //!< of a choice
  bool required = false;                //!< has no default
};

/// The value of any kind of parameter.
using ParameterValue = std::variant<bool, std::int64_t, double, std::string, std::vector<double>>;

/// The parameters of a node or a tool, described once. Each parameter struct has a free function
/// describe(ParameterTable&, Parameters&) beside it, which adds every member with its range, unit
/// and meaning; the defaults are in the struct. The kind of table decides what happens: check them
/// (check()), read them from ROS (RosParameters), make options of them (ParameterOptions), or write
/// the rows of a document (parameter_rows()).
///
///     void describe(ParameterTable& table, PeakLimits& limits) {
///       table.add("min_width", limits.min_width, {0, 1e4, "px"}, "narrower peaks are rejected");
///       table.renamed("least_width", "min_width");
///     }
///
/// All functions throw InvalidParameter, naming the parameter, if a value is not allowed.
class ParameterTable {
 public:
  /// Range of a number.
  struct Range {
    double min;                  //!< least allowed
    double max;                  //!< greatest allowed
    const char* unit = "";       //!< such as m
    Also also = Also::kNothing;  //!< also allowed
  };

  ParameterTable() = default;
  ParameterTable(const ParameterTable&) = delete;
  ParameterTable& operator=(const ParameterTable&) = delete;
  virtual ~ParameterTable() = default;

  void add(const std::string& name, bool& value, const std::string& meaning);  //!< true or false
  void add(const std::string& name, std::string& value, const std::string& meaning);  //!< a text
  /// A number.
  void add(const std::string& name, double& value, const Range& range, const std::string& meaning);

  /// @param count of numbers, unless the list is empty; 0: any
  void add(const std::string& name, std::vector<double>& value, const Range& range,
           const std::string& meaning, std::size_t count = 0);

  /// A whole number; `range` must be within the type's.
  template <class Integer, std::enable_if_t<std::is_integral_v<Integer>, int> = 0>
  void add(const std::string& name, Integer& value, const Range& range,
           const std::string& meaning) {
    value = static_cast<Integer>(whole(name, static_cast<std::int64_t>(value), range, meaning));
  }

  /// A list of exactly N numbers.
  template <int N>
  void add(const std::string& name, Eigen::Matrix<double, N, 1>& value, const Range& range,
           const std::string& meaning) {
    std::vector<double> numbers(value.begin(), value.end());
    add(name, numbers, range, meaning, N);
    if (numbers.empty()) refuse(name, "0 numbers", "give " + std::to_string(N));
    value = Eigen::Map<const Eigen::Matrix<double, N, 1>>(numbers.data());
  }

  /// A required text.
  void require(const std::string& name, std::string& value, const std::string& meaning);

  /// One of a few words.
  void choice(const std::string& name, std::string& value, const std::vector<std::string>& words,
              const std::string& meaning);

  /// @param words for the enum's values, in their order
  template <class Enum, std::enable_if_t<std::is_enum_v<Enum>, int> = 0>
  void choice(const std::string& name, Enum& value, const std::vector<std::string>& words,
              const std::string& meaning) {
    value = static_cast<Enum>(place(name, static_cast<std::size_t>(value), words, meaning));
  }

  /// The parameters of `group` under `prefix`/.
  template <class Group>
  void group(const std::string& prefix, Group& group) {
    const std::string outside = prefix_;
    prefix_ += prefix + "/";
    describe(*this, group);
    prefix_ = outside;
  }

  /// Refuses the former name of a parameter and gives the new one.
  void renamed(const std::string& old, const std::string& now);

  /// The parameter as errors name it.
  std::string full_name(const std::string& name) const { return named(prefix_ + name); }

  /// For what no range expresses, such as a minimum above its maximum.
  [[noreturn]] void refuse(const std::string& name, const std::string& value,
                           const std::string& cure) const;

 protected:
  /// Replaces `value`, the default, by what is given for the parameter.
  /// @param value must keep its type
  virtual void visit(const Parameter& parameter, ParameterValue& value) = 0;

  /// Whether a value is given under the old name of a parameter.
  virtual bool is_given(const std::string& old, const std::string& now) = 0;

  /// A parameter as errors name it.
  virtual std::string named(const std::string& name) const { return name; }

 private:
  std::int64_t whole(const std::string& name, std::int64_t value, const Range& range,
                     const std::string& meaning);
  std::size_t place(const std::string& name, std::size_t value,
                    const std::vector<std::string>& words, const std::string& meaning);
  template <class T>
  void visit_as(const Parameter& parameter, T& value);
  void check_range(const Parameter& parameter, double value) const;

  std::string prefix_;
};

/// @throw InvalidParameter naming the parameter that is out of its range
template <class Parameters>
void check(Parameters parameters);

/// The table for a document, in Markdown: a head and a row for each parameter.
template <class Parameters>
std::string parameter_rows(Parameters parameters = {});

/// Implementation of check(): changes nothing.
class RangeCheck final : public ParameterTable {
  void visit(const Parameter&, ParameterValue&) override {}
  bool is_given(const std::string&, const std::string&) override { return false; }
};

/// Implementation of parameter_rows().
class ParameterRows final : public ParameterTable {
 public:
  const std::string& text() const { return text_; }  //!< the rows in Markdown

 private:
  void visit(const Parameter& parameter, ParameterValue& value) override;
  bool is_given(const std::string&, const std::string&) override { return false; }

  std::string text_ = "| parameter | unit | range | default | |\n|---|---|---|---|---|\n";
};

template <class Parameters>
void check(Parameters parameters) {
  RangeCheck table;
  describe(table, parameters);
}

template <class Parameters>
std::string parameter_rows(Parameters parameters) {
  ParameterRows table;
  describe(table, parameters);
  return table.text();
}

/// What a parameter may be, such as "0, 1e-06 .. 10" or "affine, general"; empty: anything.
std::string range_text(const Parameter& parameter, const ParameterValue& value);

/// A default in the form for a document.
std::string default_text(const Parameter& parameter, const ParameterValue& value);

}  // namespace scan_cell_common
