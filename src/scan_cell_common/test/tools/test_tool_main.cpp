// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <stdexcept>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"
#include "scan_cell_common/tools/tool_main.h"
#include "scan_cell_common/tools/version.h"

using namespace scan_cell_common;  // NOLINT

namespace {

namespace fs = std::filesystem;

/// Runs a tool that turns an input into an output, and has a number option and two commands.
class ToolMain : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = testing::TempDir() + "tool_main";
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }

  std::string file(const std::string& name) const { return folder_ + "/" + name; }

  std::string write(const std::string& name) const {
    save_text(file(name), "of an earlier run");
    return file(name);
  }

  int run(const std::function<int()>& body, std::vector<std::string> words = {},
          int refused = kUnusable) {
    CLI::App app("tries");
    int number = 0;
    app.add_option("--number", number);
    std::string input, output, report, results;
    Outputs outputs;
    app.add_option("--input", input);
    outputs.add(app, "--output", output, "a file");
    outputs.add(app, "--report", report, "a file");
    outputs.add_folder(app, "--results", results, "a folder", {"path.csv", "report.json"});
    CLI::App* const measure = app.add_subcommand("measure");
    measure->add_option("--length", number);
    outputs.add(*measure, "--table", output, "a file");
    app.add_subcommand("compare");
    words.insert(words.begin(), "tool");
    std::vector<char*> arguments;
    for (std::string& word : words)
      arguments.push_back(word.data());
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const int code = tool_main("tool", app, static_cast<int>(words.size()), arguments.data(), body,
                               refused, outputs);
    error_ = testing::internal::GetCapturedStderr();
    output_ = testing::internal::GetCapturedStdout();
    return code;
  }

  std::string error_;
  std::string output_;
  std::string folder_;
};

int refuse() {
  throw Refused("path", "leaves the part", "check it");
}

}  // namespace

TEST_F(ToolMain, ReturnsWhatTheToolReturns) {
  EXPECT_EQ(run([] { return 0; }), 0);
  EXPECT_EQ(run([] { return 7; }), 7);
}

TEST_F(ToolMain, TurnsAnyErrorIntoOneLineThatNamesTheTool) {
  EXPECT_EQ(run([]() -> int { throw FileError("a.png", "missing", "find it"); }), kUnusable);
  EXPECT_EQ(error_, "tool: a.png: missing; find it\n");
  EXPECT_EQ(run([]() -> int { throw std::runtime_error("no memory"); }), kUnusable);
  EXPECT_EQ(error_, "tool: no memory\n");
}

TEST_F(ToolMain, TellsANoFromAFailureWhereTheToolDoes) {
  EXPECT_EQ(run(refuse), kUnusable);
  EXPECT_EQ(run(refuse, {}, kRefused), kRefused);
  EXPECT_EQ(run([]() -> int { throw UnusableInput("path", "empty", "give one"); }, {}, kRefused),
            kUnusable);
}

TEST_F(ToolMain, TakesBadOptionsForUnusableInputAndHelpForSuccess) {
  const auto body = [] { return 7; };
  EXPECT_EQ(run(body, {"--number", "five"}), kUnusable);
  EXPECT_NE(error_.find("--number"), std::string::npos) << error_;
  EXPECT_EQ(run(body, {"--nonsense"}), kUnusable);
  EXPECT_EQ(run(body, {"--help"}), 0);
  EXPECT_NE(output_.find("--number"), std::string::npos) << output_;
  EXPECT_EQ(run(body, {"--number", "5"}), 7);
}

TEST_F(ToolMain, SaysTheSuitesVersion) {
  EXPECT_EQ(run([] { return 7; }, {"--version"}), 0);
  EXPECT_EQ(output_, std::string("tool ") + suite_version() + "\n");
  EXPECT_NE(std::string(suite_version()).find('.'), std::string::npos);
}

TEST_F(ToolMain, NamesTheOptionThatWasMeant) {
  const auto body = [] { return 0; };
  const std::vector<std::pair<std::string, std::string>> slips = {
      {"--ouput", "--output"}, {"--outptu", "--output"},  {"--Output", "--output"},
      {"-output", "--output"}, {"--numbr=5", "--number"}, {"--rep", "--report"},
      {"--hlep", "--help"},    {"--versoin", "--version"}};
  for (const auto& [typed, meant] : slips) {
    EXPECT_EQ(run(body, {typed, "5"}), kUnusable) << typed;
    EXPECT_NE(error_.find("did you mean " + meant + "?"), std::string::npos) << error_;
  }
  EXPECT_EQ(run(body, {"measure", "--lenght", "5"}), kUnusable);
  EXPECT_EQ(error_, "tool: --lenght: unknown option; did you mean --length?\n");
  EXPECT_EQ(run(body, {"mesure"}), kUnusable);
  EXPECT_EQ(error_, "tool: mesure: unknown command; did you mean measure?\n");
  EXPECT_EQ(run(body, {"mesure", "--length", "5"}), kUnusable);
  EXPECT_EQ(error_, "tool: mesure: unknown command; did you mean measure?\n");
}

TEST_F(ToolMain, SuggestsNothingFarOff) {
  for (const char* word : {"--nonsense", "--x", "-", "--", "\x1b[31m", "99999999"}) {
    run([] { return 0; }, {word});
    EXPECT_EQ(error_.find("did you mean"), std::string::npos) << error_;
    EXPECT_EQ(error_.find('\x1b'), std::string::npos);
  }
}

TEST_F(ToolMain, WorksOnlyAfterTheOutputsOfAnEarlierRunAreGone) {
  const std::string output = write("out.csv"), report = write("report.json");
  fs::create_directories(file("results"));
  const std::string path = write("results/path.csv"), notes = write("results/notes.txt");
  EXPECT_EQ(run(
                [&] {
                  for (const std::string& old : {output, report, path})
                    EXPECT_FALSE(fs::exists(old)) << old;
                  return 0;
                },
                {"--output", output, "--report=" + report, "--results", file("results")}),
            0);
  EXPECT_TRUE(fs::exists(notes)) << "it belongs to somebody else";
}

TEST_F(ToolMain, LeavesNoOldOutputWhereOptionsAreBad) {
  const std::vector<std::vector<std::string>> bad = {
      {"--nonsense"}, {"--number", "five"}, {"--number"}, {"measure", "--length", "x"}, {"1", "2"}};
  for (const std::vector<std::string>& words : bad) {
    const std::string output = write("out.csv"), report = write("report.json");
    for (const bool first : {true, false}) {
      std::vector<std::string> all = {"--output", output, "--report=" + report};
      all.insert(first ? all.begin() : all.end(), words.begin(), words.end());
      EXPECT_EQ(run([] { return 0; }, all), kUnusable) << words.front();
      EXPECT_FALSE(fs::exists(output)) << words.front();
      EXPECT_FALSE(fs::exists(report)) << words.front();
    }
  }
  const std::string table = write("table.csv");
  run([] { return 0; }, {"measure", "--table", table, "--nonsense"});
  EXPECT_FALSE(fs::exists(table));
}

TEST_F(ToolMain, RemovesNothingWhereOnlyHelpIsAskedFor) {
  const std::string output = write("out.csv");
  for (const char* question : {"--help", "--version"}) {
    EXPECT_EQ(run([] { return 7; }, {"--output", output, question}), 0);
    EXPECT_TRUE(fs::exists(output)) << question;
  }
}

TEST_F(ToolMain, NeverRemovesAnInput) {
  const std::string input = write("scan.ply");
  fs::create_hard_link(input, file("linked.ply"));
  const auto body = [] { return 0; };
  for (const std::string& output : {input, file("linked.ply"), folder_ + "/none/../scan.ply"}) {
    EXPECT_EQ(run(body, {"--input", input, "--output", output}), kUnusable) << output;
    EXPECT_NE(error_.find("given twice"), std::string::npos) << error_;
    EXPECT_EQ(run(body, {"--inptu", input, "--output", output}), kUnusable) << output;
    EXPECT_EQ(run(body, {"--inptu=" + input, "--output=" + output}), kUnusable) << output;
    EXPECT_TRUE(fs::exists(input) && fs::exists(file("linked.ply"))) << output;
  }
  EXPECT_EQ(run(body, {"--output", file("a.csv"), "--report", file("a.csv")}), kUnusable);
}

TEST_F(ToolMain, RemovesAllOldOutputsOrNone) {
  const std::string input = write("scan.ply"), report = write("report.json");
  run([] { return 0; }, {"--report", report, "--input", input, "--output", input});
  EXPECT_TRUE(fs::exists(report));
}

TEST_F(ToolMain, NeverRemovesWhatIsNoRegularFile) {
  fs::create_directories(file("folder"));
  fs::create_symlink(write("elsewhere.csv"), file("link.csv"));
  for (const std::string& output : {file("folder"), file("link.csv"), std::string("/dev/null")}) {
    EXPECT_EQ(run([] { return 0; }, {"--output", output}), kUnusable) << output;
    EXPECT_NE(error_.find(output), std::string::npos) << error_;
    EXPECT_EQ(run([] { return 0; }, {"--output", output, "--nonsense"}), kUnusable);
    EXPECT_TRUE(fs::exists(output)) << output;
  }
  EXPECT_TRUE(fs::exists(file("elsewhere.csv")));
}
