// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <clocale>
#include <sstream>

#include "history/export/aqdef.h"
#include "history/export/history_csv.h"
#include "history/made_runs.h"

namespace part_recipes {
namespace {

/// A run with the places "rim" (0.12 mm) and "edge" (not known).
RunRecord small_run(std::uint64_t number, const std::string& recipe) {
  RunRecord record = made_run(number, recipe);
  record.figures.scale = 1.0123;
  record.figures.rms = 0.00004;
  record.figures.places = {{"rim", 0.00012}, {"edge", std::nullopt}};
  return record;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    EXPECT_EQ(line.back(), '\r');
    line.pop_back();
    lines.push_back(line);
  }
  return lines;
}

// Written by hand from the format's description (docs/run_history.md)
TEST(Aqdef, IsAsTheFormatSays) {
  const std::vector<std::string> expected = {
      "K0100 4",
      "K1001/1 frame",
      "K1002/1 frame",
      "K2001/1 1",
      "K2002/1 scale",
      "K2004/1 0",
      "K2022/1 6",
      "K2001/2 2",
      "K2002/2 rms",
      "K2004/2 0",
      "K2022/2 5",
      "K2142/2 mm",
      "K2001/3 3",
      "K2002/3 edge",
      "K2004/3 0",
      "K2022/3 5",
      "K2101/3 0",
      "K2110/3 -0.50000",
      "K2111/3 0.50000",
      "K2142/3 mm",
      "K2001/4 4",
      "K2002/4 rim",
      "K2004/4 0",
      "K2022/4 5",
      "K2101/4 0",
      "K2110/4 -0.50000",
      "K2111/4 0.50000",
      "K2142/4 mm",
      "K0001/1 1.012300",
      "K0002/1 0",
      "K0004/1 01.01.2026/00:00:07",
      "K0009/1 run_000007",
      "K0001/2 0.04000",
      "K0002/2 0",
      "K0004/2 01.01.2026/00:00:07",
      "K0009/2 run_000007",
      "K0001/3 0.00000",
      "K0002/3 256",
      "K0004/3 01.01.2026/00:00:07",
      "K0009/3 run_000007",
      "K0001/4 0.12000",
      "K0002/4 0",
      "K0004/4 01.01.2026/00:00:07",
      "K0009/4 run_000007",
  };
  EXPECT_EQ(lines_of(to_aqdef({{1, small_run(7, "frame")}})), expected);
}

bool has(const std::vector<std::string>& lines, const std::string& line) {
  return std::find(lines.begin(), lines.end(), line) != lines.end();
}

TEST(Aqdef, NumbersCharacteristicsOverAllParts) {
  RunRecord refused = small_run(2, "bracket");
  refused.state = RunState::kRefused;
  const auto lines =
      lines_of(to_aqdef({{1, small_run(1, "frame")}, {2, refused}, {3, small_run(3, "frame")}}));
  EXPECT_EQ(lines[0], "K0100 8");
  EXPECT_TRUE(has(lines, "K1002/2 bracket"));
  EXPECT_TRUE(has(lines, "K2002/5 scale"));
  EXPECT_TRUE(has(lines, "K0002/8 129"));  // measured, and not counted
  EXPECT_TRUE(has(lines, "K0002/7 256"));
  EXPECT_EQ(std::count(lines.begin(), lines.end(), "K0001/4 0.12000"), 2);
}

TEST(Aqdef, LeavesRepeatsOut) {
  RunRecord again = small_run(2, "frame");
  again.again_of = "run_000001";
  EXPECT_EQ(to_aqdef({{1, small_run(1, "frame")}, {2, again}}),
            to_aqdef({{1, small_run(1, "frame")}}));
}

TEST(Aqdef, KeepsNamesInTheirLine) {
  RunRecord record = small_run(1, "a\r\nK0100 99\x14\x0f");
  record.figures.places = {{"Größe <b>", 0.0}};
  const std::string text = to_aqdef({{1, record}});
  EXPECT_EQ(text.substr(0, 3), "\xef\xbb\xbf");
  EXPECT_EQ(text.find_first_of("\x14\x0f"), std::string::npos);
  const auto lines = lines_of(text);
  EXPECT_TRUE(has(lines, "K1002/1 a  K0100 99  "));
  EXPECT_TRUE(has(lines, "K2002/3 Größe <b>"));
}

TEST(Aqdef, CutsLongNamesBetweenLetters) {
  std::string name;
  for (int i = 0; i < 100; ++i)
    name += "ü";
  const auto lines = lines_of(to_aqdef({{1, small_run(1, name)}}));
  EXPECT_TRUE(has(lines, "K1001/1 " + name.substr(0, 2 * 30)));
  EXPECT_TRUE(has(lines, "K1002/1 " + name.substr(0, 2 * 80)));
}

TEST(Csv, HasALineEachWithLengthsInMillimetres) {
  RunRecord record = small_run(7, "frame");
  record.figures.largest_displacement = std::nullopt;
  const auto lines = lines_of(to_csv({{3, record}}));
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0],
            "sequence,state,id,recipe,recipe_folder,recipe_sha256,started,ended,host,version,"
            "reason,message,scan_units,again_of,note,tolerance_mm,scale,rms_mm,"
            "largest_displacement_mm,expected_error_normal_mm,expected_error_tangential_mm,"
            "expected_error_orientation_deg,deviation_rms_mm,deviation_min_mm,deviation_max_mm,"
            "place edge [mm],place rim [mm]");
  EXPECT_EQ(lines[1],
            "3,accepted,run_000007,frame,/recipes/frame,0123,2026-01-01T00:00:07.000Z,"
            "2026-01-01T00:00:08.000Z,cell-7,0.1.0,accepted,message 7,m,,,0.5,1.0123,0.04,,,,,,,,,"
            "0.12");
}

TEST(Csv, QuotesWhatHoldsItsSigns) {
  RunRecord record = small_run(1, "a,\"b\"\nc");
  const std::string text = to_csv({{1, record}});
  EXPECT_NE(text.find(",\"a,\"\"b\"\"\nc\","), std::string::npos);
}

TEST(Exports, DoNotDependOnTheLocale) {
  const std::string csv = to_csv({{1, small_run(1, "frame")}});
  const std::string aqdef = to_aqdef({{1, small_run(1, "frame")}});
  for (const char* locale : {"de_DE.UTF-8", "fr_FR.UTF-8", "C"}) {
    if (std::setlocale(LC_ALL, locale) == nullptr) continue;  // not on this machine
    EXPECT_EQ(to_csv({{1, small_run(1, "frame")}}), csv);
    EXPECT_EQ(to_aqdef({{1, small_run(1, "frame")}}), aqdef);
  }
  std::setlocale(LC_ALL, "C");
}

}  // namespace
}  // namespace part_recipes
