// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <stdexcept>

#include "scan_cell_common/errors.h"
#include "scan_cell_common/tool_main.h"

using namespace scan_cell_common;  // NOLINT

namespace {

/// Runs a tool with one option that is a number.
class ToolMain : public testing::Test {
 protected:
  int run(const std::function<int()>& body, std::vector<std::string> words = {},
          int refused = kUnusable) {
    CLI::App app("tries");
    int number = 0;
    app.add_option("--number", number);
    words.insert(words.begin(), "tool");
    std::vector<char*> arguments;
    for (std::string& word : words)
      arguments.push_back(word.data());
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const int code =
        tool_main("tool", app, static_cast<int>(words.size()), arguments.data(), body, refused);
    error_ = testing::internal::GetCapturedStderr();
    output_ = testing::internal::GetCapturedStdout();
    return code;
  }

  std::string error_;
  std::string output_;
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
