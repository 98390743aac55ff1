// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <functional>
#include <limits>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/parameters/parameter_options.h"
#include "scan_cell_common/parameters/parameter_table.h"
#include "scan_cell_common/testing/parameter_test.h"

using namespace scan_cell_common;

namespace {

enum class Colour { kRed, kGreen };

struct Lens {
  double focal_length = 0.016;
};

struct Settings {
  double max_rate = 50;
  double spacing = 0;
  double limit = std::numeric_limits<double>::infinity();
  std::uint16_t port = 5410;
  std::size_t max_points = 50'000'000;
  bool loud = false;
  std::string scanner;
  Colour colour = Colour::kGreen;
  Eigen::Vector3d leaf{0.002, 0.002, 0.0005};
  std::vector<double> pose;
  Lens lens;
};

void describe(ParameterTable& table, Lens& lens) {
  table.add("focal_length", lens.focal_length, {0.001, 1, "m"}, "of the lens");
  table.renamed("focal", "focal_length");
}

void describe(ParameterTable& table, Settings& settings) {
  const double infinite = std::numeric_limits<double>::infinity();
  table.add("max_rate", settings.max_rate, {1, 100, "Hz"}, "of the frames");
  table.renamed("most_rate", "max_rate");
  table.add("spacing", settings.spacing, {1e-6, 10, "m", Also::kZero}, "0: its own");
  table.add("limit", settings.limit, {-infinite, infinite, "m"}, "by hand");
  table.add("port", settings.port, {1, 65535}, "");
  table.add("max_points", settings.max_points, {1000, 2e8}, "of a scan");
  table.add("loud", settings.loud, "says more");
  table.require("scanner", settings.scanner, "path of its model");
  table.choice("colour", settings.colour, {"red", "green"}, "of the line");
  table.add("leaf", settings.leaf, {1e-6, 1, "m"}, "of the grid");
  table.add("pose", settings.pose, {-1e3, 1e3}, "x y z qx qy qz qw", 7);
  table.group("lens", settings.lens);
}

/// The message of a refusal.
std::string refusal(const std::function<void()>& act) {
  try {
    act();
  } catch (const InvalidParameter& error) {
    return error.what();
  }
  return "nothing";
}

/// Reads a command line.
Settings typed(const std::vector<std::string>& words, const std::set<std::string>& only = {}) {
  CLI::App app;
  Settings settings;
  ParameterOptions options;
  options.add(app, settings, only);
  app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
  options.read(settings);
  return settings;
}

}  // namespace

TEST(ParameterTable, ChecksEveryRange) {
  const auto refused = [](const std::function<void(Settings&)>& spoil) {
    Settings settings;
    spoil(settings);
    return refusal([&] { check(settings); });
  };
  EXPECT_EQ(refused([](Settings&) {}), "nothing");
  EXPECT_EQ(refused([](Settings& s) { s.max_rate = 101; }),
            "max_rate: 101; give a value from 1 to 100");
  EXPECT_EQ(refused([](Settings& s) { s.max_rate = std::nan(""); }),
            "max_rate: nan; give a value from 1 to 100");
  EXPECT_EQ(refused([](Settings& s) { s.spacing = 1e-7; }),
            "spacing: 1e-07; give a value from 1e-06 to 10, or 0");
  EXPECT_EQ(refused([](Settings& s) { s.limit = std::nan(""); }),
            "limit: nan; give a value from -inf to inf");
  EXPECT_EQ(refused([](Settings& s) { s.port = 0; }), "port: 0; give a value from 1 to 65535");
  EXPECT_EQ(refused([](Settings& s) { s.leaf.z() = 0; }), "leaf: 0; give a value from 1e-06 to 1");
  EXPECT_EQ(refused([](Settings& s) { s.pose = {1, 2}; }), "pose: 2 numbers; give 7");
  EXPECT_EQ(refused([](Settings& s) { s.lens.focal_length = 2; }),
            "lens/focal_length: 2; give a value from 0.001 to 1");
}

TEST(ParameterTable, ReadsOptions) {
  const Settings settings = typed({"--max-rate",
                                   "60",
                                   "--port",
                                   "5411",
                                   "--max-points",
                                   "1000",
                                   "--loud",
                                   "--scanner",
                                   "s",
                                   "--colour",
                                   "red",
                                   "--lens-focal-length",
                                   "0.025",
                                   "--leaf",
                                   "0.1",
                                   "0.2",
                                   "0.3",
                                   "--pose",
                                   "1",
                                   "2",
                                   "-3",
                                   "0",
                                   "0",
                                   "0",
                                   "1"});
  EXPECT_EQ(settings.max_rate, 60);
  EXPECT_EQ(settings.port, 5411);
  EXPECT_EQ(settings.max_points, 1000U);
  EXPECT_TRUE(settings.loud);
  EXPECT_EQ(settings.scanner, "s");
  EXPECT_EQ(settings.colour, Colour::kRed);
  EXPECT_EQ(settings.leaf, Eigen::Vector3d(0.1, 0.2, 0.3));
  EXPECT_EQ(settings.pose, (std::vector<double>{1, 2, -3, 0, 0, 0, 1}));
  EXPECT_EQ(settings.lens.focal_length, 0.025);
  EXPECT_EQ(typed({"--scanner", "s"}).max_rate, 50);
}

TEST(ParameterTable, RefusesBadOptionsByName) {
  const auto refused = [](std::vector<std::string> words) {
    words.insert(words.end(), {"--scanner", "s"});
    return refusal([&] { typed(words); });
  };
  EXPECT_EQ(refused({"--max-rate", "101"}), "--max-rate: 101; give a value from 1 to 100");
  EXPECT_EQ(refused({"--max-rate", "fast"}), "--max-rate: 'fast'; give a number");
  EXPECT_EQ(refused({"--port", "5410.5"}), "--port: 5410.5; give a whole number");
  EXPECT_EQ(refused({"--port", "-1"}), "--port: -1; give a value from 1 to 65535");
  EXPECT_EQ(refused({"--port", "65537"}), "--port: 65537; give a value from 1 to 65535");
  EXPECT_EQ(refused({"--colour", "blue"}), "--colour: 'blue'; give one of red, green");
  EXPECT_EQ(refused({"--most-rate", "5"}), "--most-rate: renamed; use --max-rate");
  EXPECT_EQ(refused({"--lens-focal"}), "--lens-focal: renamed; use --lens-focal-length");
  EXPECT_THROW(typed({}), CLI::RequiredError);
  EXPECT_THROW(typed({"--scanner", "s", "--leaf", "1", "2"}), CLI::ArgumentMismatch);
  EXPECT_THROW(typed({"--scanner", "s", "--port", "1", "--port", "2"}), CLI::ArgumentMismatch);
}

TEST(ParameterTable, MakesOptionsOfThoseThatAToolTakes) {
  EXPECT_EQ(typed({"--port", "1"}, {"port"}).port, 1);
  EXPECT_THROW(typed({"--max-rate", "5"}, {"port"}), CLI::ExtrasError);
  EXPECT_THROW(typed({"--most-rate", "5"}, {"port"}), CLI::ExtrasError);
}

TEST(ParameterTable, ExplainsOptionsWithUnitRangeAndDefault) {
  CLI::App app;
  ParameterOptions options;
  options.add(app, Settings{});
  std::string help = app.help();
  help.erase(
      std::unique(help.begin(), help.end(), [](char a, char b) { return a == ' ' && b == ' '; }),
      help.end());
  EXPECT_NE(help.find("--max-rate FLOAT=50 of the frames [Hz]; 1 .. 100"), std::string::npos)
      << help;
  EXPECT_EQ(help.find("most"), std::string::npos) << help;
}

TEST(ParameterTable, WritesTheRowsOfADocument) {
  EXPECT_EQ(parameter_rows<Settings>(),
            "| parameter | unit | range | default | |\n"
            "|---|---|---|---|---|\n"
            "| `max_rate` | Hz | 1 .. 100 | 50 | of the frames |\n"
            "| `spacing` | m | 0, 1e-06 .. 10 | 0 | 0: its own |\n"
            "| `limit` | m | | none | by hand |\n"
            "| `port` | | 1 .. 65535 | 5410 | |\n"
            "| `max_points` | | 1000 .. 2e+08 | 50000000 | of a scan |\n"
            "| `loud` | | | false | says more |\n"
            "| `scanner` | | | required | path of its model |\n"
            "| `colour` | | red, green | green | of the line |\n"
            "| `leaf` | m | 1e-06 .. 1, 3 numbers | 0.002, 0.002, 0.0005 | of the grid |\n"
            "| `pose` | | -1000 .. 1000, 7 numbers | none | x y z qx qy qz qw |\n"
            "| `lens/focal_length` | m | 0.001 .. 1 | 0.016 | of the lens |\n");
}

TEST(ParameterTable, RefusesOldNamesAndSaysTheNewOnes) {
  expect_renamed<Settings>({{"most_rate", "max_rate"}, {"lens/focal", "lens/focal_length"}});
}
