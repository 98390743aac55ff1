// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "history/history.h"
#include "history/made_history.h"
#include "history/made_runs.h"
#include "scan_cell_common/files/files.h"

namespace part_recipes {
namespace {

namespace fs = std::filesystem;

using scan_cell_common::read_file;

/// A command's exit code and what it printed on both outputs.
struct Answer {
  int code = 0;
  std::string text;
};

class HistoryTool : public testing::Test {
 protected:
  const fs::path& runs() const { return folder_.path(); }

  void add(const RunRecord& record) const { History(runs()).add(write_run(runs(), record)); }

  /// @param words without the single quote
  Answer run(const std::vector<std::string>& words) const {
    std::string line = "cd '" + runs().string() + "' && " HISTORY_TOOL;
    for (const std::string& word : words)
      line += " '" + word + "'";
    std::FILE* const pipe = popen((line + " 2>&1").c_str(), "r");
    Answer answer;
    std::array<char, 4096> buffer{};
    for (std::size_t count = 0; (count = fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
      answer.text.append(buffer.data(), count);
    const int status = pclose(pipe);
    answer.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return answer;
  }

 private:
  TemporaryFolder folder_;
};

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST_F(HistoryTool, ListsShowsAndFilters) {
  add(made_run(1));
  RunRecord refused = made_run(2, "bracket");
  refused.state = RunState::kRefused;
  refused.reason = "wrong_part";
  add(refused);
  const Answer all = run({"list", "--runs", "."});
  EXPECT_EQ(all.code, 0);
  EXPECT_TRUE(has(all.text, "run_000001") && has(all.text, "run_000002")) << all.text;
  const Answer some = run({"list", "--runs", ".", "--reason", "wrong_part", "--csv"});
  EXPECT_FALSE(has(some.text, "run_000001"));
  EXPECT_TRUE(has(some.text, "2,refused,run_000002,bracket,")) << some.text;
  const Answer shown = run({"show", "run_000001", "--runs", "."});
  EXPECT_TRUE(has(shown.text, "message 1") && has(shown.text, "0.0010 mm")) << shown.text;
  EXPECT_EQ(run({"show", "run_000009", "--runs", "."}).code, 1);
}

TEST_F(HistoryTool, KeepsWhoApprovedOrRefusedARun) {
  add(made_run(1));
  RunRecord wrong = made_run(2);
  wrong.state = RunState::kRefused;
  add(wrong);
  const Answer refused =
      run({"refuse", "run_000001", "--runs", ".", "--name", "Ada", "--note", "clamp was loose"});
  EXPECT_EQ(refused.text, "run_000001 refused by Ada\n");
  EXPECT_EQ(run({"approve", "run_000001", "--runs", ".", "--name", "Jörg"}).code, 0);
  const std::string shown = run({"show", "run_000001", "--runs", "."}).text;
  EXPECT_TRUE(has(shown, "by Ada at 2") && has(shown, ": clamp was loose")) << shown;
  EXPECT_LT(shown.find("by Ada"), shown.find("by Jörg"));
  const Answer unfit = run({"approve", "run_000002", "--runs", ".", "--name", "Ada"});
  EXPECT_EQ(unfit.code, 2);
  EXPECT_TRUE(has(unfit.text, "only an accepted path")) << unfit.text;
  EXPECT_EQ(run({"approve", "../run_000001", "--runs", ".", "--name", "Ada"}).code, 1);
  EXPECT_EQ(run({"approve", "run_000001", "--runs", ".", "--name", ""}).code, 1);
}

TEST_F(HistoryTool, AddsARunAndRebuilds) {
  write_run(runs(), made_run(1));
  const Answer added = run({"add", "run_000001"});
  EXPECT_EQ(added.text, "run_000001 added\n");
  EXPECT_EQ(run({"add", "run_000001/"}).text, "run_000001 is already in the history\n");
  fs::create_directory(runs() / "torn");
  std::ofstream(runs() / "torn" / kRunFile) << "{";
  const Answer list = run({"list", "--runs", "."});
  EXPECT_TRUE(has(list.text, "warning: 1 runs")) << list.text;
  const Answer rebuilt = run({"rebuild", "--runs", "."});
  EXPECT_EQ(rebuilt.code, 2);
  EXPECT_TRUE(has(rebuilt.text, "left out: ./torn/run.json")) << rebuilt.text;
  EXPECT_TRUE(has(rebuilt.text, "1 runs in ./history.sqlite")) << rebuilt.text;
}

TEST_F(HistoryTool, TellsWhatIsWrongByItsName) {
  EXPECT_TRUE(has(run({"list", "--runs", "nowhere"}).text, "nowhere: no such folder"));
  const Answer missing = run({"list", "--runs", "."});
  EXPECT_EQ(missing.code, 1);
  EXPECT_TRUE(has(missing.text, "history rebuild --runs")) << missing.text;
  add(made_run(1));
  EXPECT_TRUE(has(run({"list", "--runs", ".", "--since", "today"}).text, "since: 'today'"));
  const Answer other = run({"chart-data", "--runs", ".", "--recipe", "none"});
  EXPECT_EQ(other.code, 1);
  EXPECT_TRUE(has(other.text, "recipe 'none': no such runs")) << other.text;
  const Answer ending = run({"aqdef", "out.txt", "--runs", "."});
  EXPECT_EQ(ending.code, 1);
  EXPECT_TRUE(has(ending.text, ".dfq")) << ending.text;
}

TEST_F(HistoryTool, RemovesAnOldOutputWhereItFails) {
  add(made_run(1));
  std::ofstream(runs() / "old.csv") << "old";
  EXPECT_EQ(run({"csv", "old.csv", "--runs", ".", "--state", "good"}).code, 1);
  EXPECT_FALSE(fs::exists(runs() / "old.csv"));
}

TEST_F(HistoryTool, WritesTablesAndChartData) {
  for (const RunRecord& record : made_history(30, "frame"))
    write_run(runs(), record);
  History(runs()).rebuild();
  EXPECT_EQ(run({"csv", "all.csv", "--runs", "."}).text, "");
  EXPECT_EQ(run({"aqdef", "all.dfq", "--runs", "."}).text, "");
  EXPECT_EQ(read_file((runs() / "all.dfq").string()).substr(0, 9), "K0100 5\r\n");
  const Answer data = run({"chart-data", "--runs", ".", "--recipe", "frame", "--limit", "12"});
  EXPECT_EQ(nlohmann::json::parse(data.text).at("runs").size(), 12u);
}

TEST_F(HistoryTool, DrawsAPageInWhichNamesStayText) {
  const std::string name = "<script>alert(1)</script> Größe ../../x $x_1$ & \"q\"\nb";
  auto records = made_history(40, name);
  records[5].reason = "<img src=x onerror=alert(2)>";
  records[5].state = RunState::kRefused;
  records[6].figures.places["<b>flank</b> $\\alpha"] = 0.0001;
  for (const RunRecord& record : records)
    write_run(runs(), record);
  History(runs()).rebuild();
  const Answer drawn = run({"chart", "--runs", ".", "--recipe", name, "--output", "page.html"});
  ASSERT_EQ(drawn.code, 0) << drawn.text;
  const std::string page = read_file((runs() / "page.html").string());
  EXPECT_FALSE(has(page, "<script") || has(page, "<img src=x") || has(page, "<b>"));
  EXPECT_TRUE(has(page, "&lt;script&gt;alert(1)&lt;/script&gt; Größe ../../x $x_1$ &amp; "));
  EXPECT_TRUE(has(page, "&lt;img src=x onerror=alert(2)&gt;"));
  EXPECT_TRUE(has(page, "&lt;b&gt;flank&lt;/b&gt; $\\alpha"));
  EXPECT_FALSE(has(page, "http:") || has(page, "https:") || has(page, "<link"));
  const Answer png = run({"chart", "--runs", ".", "--recipe", name, "--output", "page.png"});
  ASSERT_EQ(png.code, 0) << png.text;
  EXPECT_EQ(read_file((runs() / "page.png").string()).substr(1, 3), "PNG");
}

TEST_F(HistoryTool, DrawsARecipeWithoutAnyFigure) {
  RunRecord refused = made_run(1, "frame");
  refused.state = RunState::kRefused;
  refused.reason = "too_few_points";
  refused.figures = {};
  add(refused);
  const Answer drawn = run({"chart", "--runs", ".", "--recipe", "frame", "--output", "page.html"});
  ASSERT_EQ(drawn.code, 0) << drawn.text;
  EXPECT_TRUE(has(read_file((runs() / "page.html").string()), "too_few_points"));
}

}  // namespace
}  // namespace part_recipes
