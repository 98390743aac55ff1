// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "made_up_recipe.h"
#include "view/judged_figures.h"

namespace part_recipes {
namespace {

/// A run's folder with a recipe and a report.
class JudgedFigures : public testing::Test {
 protected:
  JudgedFigures() {
    std::filesystem::create_directories(folder_.path() / "inputs");
    save("inputs/recipe.yaml",
         "recipe: 1\nname: plate\nreference: {file: plate.stl, units: mm}\n"
         "path: {file: path.csv, units: m}\ntolerance: 0.0005\n"
         "stretch: {max_position_error: 0.0005, min_overlap: 0.4}\n");
    save("report.json", R"({"inlier_ratio": 0.7, "overlap": 0.45})");
    record_.state = RunState::kRefused;
    record_.tolerance = 0.0003;
  }

  void save(const char* name, const std::string& text) const {
    scan_cell_common::save_text((folder_.path() / name).string(), text);
  }

  JudgedFigure find(const std::string& name) const {
    const std::vector<std::pair<std::string, std::string>> texts = {
        {"scale", "1.00"},
        {"rms", "0.02 mm"},
        {"expected_error_tangential", "0.03 mm"},
        {"expected_error_orientation", "1 deg"},
        {"deviation_max", "0.1 mm"},
        {"place rim", "0"}};
    for (const JudgedFigure& figure : judged_figures(folder_.path(), record_, texts))
      if (figure.name == name) return figure;
    return {};
  }

  TemporaryFolder folder_;
  RunRecord record_;
};

TEST_F(JudgedFigures, StandBesideTheLimitsThatTheRecipeGivesElseTheDefaults) {
  EXPECT_EQ(find("expected_error_tangential").value, "0.03 mm");
  EXPECT_EQ(find("expected_error_tangential").limit, "at most 0.5 mm");
  EXPECT_EQ(find("overlap").value, "45.00 %");
  EXPECT_EQ(find("overlap").limit, "at least 40 %");
  EXPECT_EQ(find("inlier_ratio").limit, "at least 80 %");
  EXPECT_EQ(find("expected_error_orientation").limit, "at most 4.98 deg");
  EXPECT_EQ(find("scale").limit, "0.45 to 2.2");
  EXPECT_EQ(find("deviation_max").limit, "good within 0.3 mm");
  EXPECT_EQ(find("place rim").limit, "good within 0.3 mm");
  EXPECT_EQ(find("rms").limit, "");
}

TEST_F(JudgedFigures, HaveTheRangeOfAScaleThatIsKnown) {
  const auto scale_with = [this](const std::string& stretch) {
    save("inputs/recipe.yaml",
         "recipe: 1\nname: plate\nreference: {file: plate.stl, units: mm}\n"
         "path: {file: path.csv, units: m}\ntolerance: 0.0005\nstretch: " +
             stretch + "\n");
    return find("scale").limit;
  };
  EXPECT_EQ(scale_with("{scale: 1, scale_deviation: 0.01}"), "0.96 to 1.04");
  EXPECT_EQ(scale_with("{scale: 1, scale-deviation: 0.01, max-scale: 1.02}"), "0.96 to 1.02");
  EXPECT_EQ(scale_with("{scale: 1.5}"), "exactly 1.5");
  EXPECT_EQ(scale_with("{scale: 3}").substr(0, 4), "none");
}

TEST_F(JudgedFigures, HaveNoLimitByWhichTheyAreNotJudged) {
  save("inputs/recipe.yaml",
       "recipe: 1\nname: plate\nreference: {file: plate.xyz, units: mm}\n"
       "path: {file: path.csv, units: m}\ntolerance: 0.0005\n");
  EXPECT_EQ(find("expected_error_tangential").limit, "") << "a cloud's edges are not known";
  record_.state = RunState::kAccepted;
  EXPECT_EQ(find("inlier_ratio").value, "70.00 %");
  EXPECT_EQ(find("inlier_ratio").limit, "") << "the reference shows a part alone";
}

TEST_F(JudgedFigures, AreThereWhereRecipeOrReportCannotBeRead) {
  save("inputs/recipe.yaml", "recipe: 1\nstretch: {min_overlap: much}\n");
  save("report.json", "no report");
  EXPECT_EQ(find("scale").value, "1.00");
  EXPECT_EQ(find("scale").limit, "");
  EXPECT_EQ(find("overlap").name, "");
}

}  // namespace
}  // namespace part_recipes
