// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <tecnogamma_camera/CameraConfig.h>

#include "parameters.h"
#include "scan_cell_common/testing/parameter_test.h"

using scan_cell_common::Parameter;
using tecnogamma_camera::CameraConfig;
using tecnogamma_camera::Parameters;

namespace {

struct Row {
  double min, max, value;
};

/// The numbers of a table.
class Numbers final : public scan_cell_common::ParameterTable {
 public:
  std::map<std::string, Row> rows;

 private:
  void visit(const Parameter& parameter, scan_cell_common::ParameterValue& value) override {
    if (const auto* number = std::get_if<double>(&value))
      rows[parameter.name] = {parameter.min, parameter.max, *number};
    if (const auto* whole = std::get_if<std::int64_t>(&value))
      rows[parameter.name] = {parameter.min, parameter.max, static_cast<double>(*whole)};
  }
  bool is_given(const std::string&, const std::string&) override { return false; }
};

std::map<std::string, double> numbers_of(const CameraConfig& config) {
  dynamic_reconfigure::Config message;
  config.__toMessage__(message);
  std::map<std::string, double> numbers;
  for (const auto& number : message.doubles)
    numbers[number.name] = number.value;
  for (const auto& number : message.ints)
    numbers[number.name] = number.value;
  return numbers;
}

}  // namespace

TEST(Parameters, AreAllInTheDocument) {
  scan_cell_common::expect_documented<Parameters>(
      DOCUMENT, "rosrun tecnogamma_camera tecnogamma_camera_node --parameters");
}

TEST(Parameters, AreRefusedByTheirOldNamesWithTheNewOnes) {
  scan_cell_common::expect_renamed<Parameters>({{"most_width", "max_width"}});
}

TEST(Parameters, HaveTheSameRangesAndDefaultsInDynamicReconfigure) {
  Numbers table;
  Parameters parameters;
  describe(table, parameters);
  const auto min = numbers_of(CameraConfig::__getMin__());
  const auto max = numbers_of(CameraConfig::__getMax__());
  for (const auto& [name, value] : numbers_of(CameraConfig::__getDefault__())) {
    ASSERT_EQ(table.rows.count(name), 1U) << name;
    const Row& row = table.rows.at(name);
    EXPECT_EQ(row.min, min.at(name)) << name;
    EXPECT_EQ(row.max, max.at(name)) << name;
    EXPECT_EQ(row.value, value) << name;
  }
}
