// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

#include "history/history.h"
#include "history/made_runs.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"

namespace part_recipes {
namespace {

namespace fs = std::filesystem;

using scan_cell_common::Error;
using scan_cell_common::FileError;
using scan_cell_common::InvalidParameter;
using scan_cell_common::Refused;
using scan_cell_common::UnusableInput;

class HistoryTest : public testing::Test {
 protected:
  fs::path runs() const { return folder_.path(); }
  History history() const { return History(runs()); }

  void add(const RunRecord& record) const { history().add(write_run(runs(), record)); }

  std::vector<std::string> ids(const HistoryFilter& filter = {}) const {
    std::vector<std::string> found;
    for (const HistoryRun& run : history().query(filter))
      found.push_back(run.record.id);
    return found;
  }

 private:
  TemporaryFolder folder_;
};

using Ids = std::vector<std::string>;

TEST_F(HistoryTest, GivesBackAllThatWasAdded) {
  RunRecord record = made_run(7, "Größe <b>ü</b> ../'; DROP TABLE runs; --\n$x$");
  record.again_of = "run_000003";
  record.note = "it's \"quoted\"";
  record.figures.expected_error_normal = 0.0001;
  record.figures.places["<script>"] = -0.25;
  add(record);
  const auto found = history().query({});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].record.recipe_name, record.recipe_name);
  EXPECT_EQ(found[0].record.note, record.note);
  EXPECT_EQ(found[0].record.again_of, record.again_of);
  EXPECT_EQ(found[0].record.started, record.started);
  EXPECT_EQ(found[0].record.state, RunState::kAccepted);
  EXPECT_EQ(found[0].record.tolerance, 0.0005);
  EXPECT_EQ(found[0].record.figures.scale, record.figures.scale);
  EXPECT_EQ(found[0].record.figures.expected_error_normal, 0.0001);
  EXPECT_EQ(found[0].record.figures.deviation_rms, std::nullopt);
  EXPECT_EQ(found[0].record.figures.places, record.figures.places);
}

TEST_F(HistoryTest, AddsARunOnce) {
  const fs::path folder = write_run(runs(), made_run(1));
  EXPECT_TRUE(history().add(folder));
  EXPECT_FALSE(history().add(folder));
  EXPECT_FALSE(history().add(folder / ""));
  EXPECT_EQ(history().query({}).size(), 1u);
}

TEST_F(HistoryTest, RefusesAnotherRunOfTheSameId) {
  add(made_run(1));
  fs::remove_all(runs() / "run_000001");
  RunRecord other = made_run(1);
  other.note = "changed";
  EXPECT_THROW(history().add(write_run(runs(), other)), Refused);
  EXPECT_EQ(history().query({}).front().record.note, "");
}

TEST_F(HistoryTest, RefusesAFolderThatIsNotWithTheOthers) {
  const TemporaryFolder elsewhere;
  EXPECT_THROW(history().add(write_run(elsewhere.path(), made_run(1))), Refused);
}

TEST_F(HistoryTest, RefusesABrokenRunByItsFile) {
  const auto message = [this](const fs::path& folder) -> std::string {
    try {
      history().add(folder);
    } catch (const UnusableInput& error) {
      return error.thing();
    }
    return "";
  };
  fs::create_directory(runs() / "torn");
  std::ofstream(runs() / "torn" / kRunFile) << R"({"format": 1, "id": "to)";
  EXPECT_EQ(message(runs() / "torn"), (runs() / "torn" / kRunFile).string());
  write_run(runs(), made_run(1));
  fs::rename(runs() / "run_000001", runs() / "copy");
  EXPECT_EQ(message(runs() / "copy"), (runs() / "copy" / kRunFile).string());
  RunRecord timeless = made_run(2);
  timeless.started = "yesterday";
  EXPECT_EQ(message(write_run(runs(), timeless)), (runs() / "run_000002" / kRunFile).string());
}

TEST_F(HistoryTest, FiltersByEverything) {
  for (const std::uint64_t number : {1, 2, 3})
    add(made_run(number));
  RunRecord refused = made_run(86400, "bracket");
  refused.state = RunState::kRefused;
  refused.reason = "wrong_part";
  refused.message = "100% another_part";
  add(refused);
  HistoryFilter filter;
  filter.recipe = "bracket";
  EXPECT_EQ(ids(filter), Ids{"run_086400"});
  filter.recipe = "Bracket";
  EXPECT_EQ(ids(filter), Ids{});
  filter = {};
  filter.state = "accepted";
  EXPECT_EQ(ids(filter), (Ids{"run_000001", "run_000002", "run_000003"}));
  filter.limit = 2;
  EXPECT_EQ(ids(filter), (Ids{"run_000002", "run_000003"}));
  filter = {};
  filter.reason = "wrong_part";
  EXPECT_EQ(ids(filter), Ids{"run_086400"});
  filter = {};
  filter.text = "0% ANOTHER_";
  EXPECT_EQ(ids(filter), Ids{"run_086400"});
  filter.text = "1%another";
  EXPECT_EQ(ids(filter), Ids{});
  filter.text = "100_ another";
  EXPECT_EQ(ids(filter), Ids{});
}

TEST_F(HistoryTest, FiltersByTimesOfAnyPrecision) {
  for (const std::uint64_t number : {0, 1, 59, 60, 86400})
    add(made_run(number));
  const auto between = [this](const char* since, const char* until) {
    HistoryFilter filter;
    filter.since = since;
    filter.until = until;
    return ids(filter);
  };
  EXPECT_EQ(between("2026", "2026").size(), 5u);
  EXPECT_EQ(between("2026-01-02", "2026-01"), Ids{"run_086400"});
  EXPECT_EQ(between("2026-01-01T00:00:01Z", "2026-01-01T00:00"), (Ids{"run_000001", "run_000059"}));
  EXPECT_EQ(between("2026-01-01T00:01:00.000Z", "2026-01-01"), Ids{"run_000060"});
  EXPECT_EQ(between("2026-01-01T00", "2026-01-01T00").size(), 4u);
  EXPECT_EQ(between("2027", "2028"), Ids{});
}

TEST_F(HistoryTest, RefusesAFilterByItsName) {
  add(made_run(1));
  const auto fault = [this](HistoryFilter filter) -> std::string {
    try {
      history().query(filter);
    } catch (const InvalidParameter& error) {
      return error.thing();
    }
    return "";
  };
  HistoryFilter filter;
  for (const char* time :
       {"", "yesterday", "2026-13", "2026-02-29", "2026-01-01 12:00", "2026-01-01T24:00",
        "2026-01-01T12:60", "2026-01-01T12:30:61", "26-01-01"}) {
    filter.since = time;
    EXPECT_EQ(fault(filter), "since") << time;
  }
  filter = {};
  filter.until = "31.12.2026";
  EXPECT_EQ(fault(filter), "until");
  filter = {};
  filter.state = "good";
  EXPECT_EQ(fault(filter), "state");
  filter = {};
  filter.limit = 0;
  EXPECT_EQ(fault(filter), "limit");
}

TEST_F(HistoryTest, KeepsTheOrderOfAddingWhereTheClockWentBack) {
  add(made_run(100));
  RunRecord earlier = made_run(50);
  add(earlier);
  add(made_run(101));
  EXPECT_EQ(ids(), (Ids{"run_000100", "run_000050", "run_000101"}));
  EXPECT_EQ(history().query({})[1].record.started, earlier.started);
  history().rebuild();
  EXPECT_EQ(ids(), (Ids{"run_000100", "run_000050", "run_000101"}));
}

TEST_F(HistoryTest, RebuildPutsRunsThatWereNotAddedWhereTheyStarted) {
  add(made_run(10));
  add(made_run(30));
  add(made_run(20));  // after the clock went back
  add(made_run(40));
  write_run(runs(), made_run(5));
  write_run(runs(), made_run(15));
  write_run(runs(), made_run(35));
  write_run(runs(), made_run(99));
  EXPECT_EQ(history().rebuild().runs, 8u);
  EXPECT_EQ(ids(), (Ids{"run_000005", "run_000010", "run_000015", "run_000030", "run_000020",
                        "run_000035", "run_000040", "run_000099"}));
}

TEST_F(HistoryTest, RebuildLeavesOutWhatIsNoRunAndTellsWhatIsBroken) {
  add(made_run(1));
  add(made_run(2));
  fs::remove_all(runs() / "run_000002");
  write_run(runs(), made_run(3));
  fs::create_directory(runs() / ".run_000009");
  scan_cell_common::save_text((runs() / ".run_000009" / kRunFile).string(), to_json(made_run(9)));
  fs::create_directory(runs() / "under_way");
  fs::create_directory(runs() / "torn");
  std::ofstream(runs() / "torn" / kRunFile) << "{";
  std::ofstream(runs() / "notes.txt") << "no folder";
  const Rebuilt rebuilt = history().rebuild();
  EXPECT_EQ(rebuilt.runs, 2u);
  ASSERT_EQ(rebuilt.broken.size(), 1u);
  EXPECT_EQ(rebuilt.broken[0].first, "torn");
  EXPECT_NE(rebuilt.broken[0].second.find(kRunFile), std::string::npos);
  EXPECT_EQ(rebuilt.gone, Ids{"run_000002"});
  EXPECT_EQ(rebuilt.order_lost, "");
  EXPECT_EQ(ids(), (Ids{"run_000001", "run_000003"}));
  EXPECT_EQ(history().left_out(), Ids{"torn"});
}

TEST_F(HistoryTest, TellsRunsThatItDoesNotHave) {
  add(made_run(1));
  write_run(runs(), made_run(2));
  EXPECT_EQ(history().left_out(), Ids{"run_000002"});
}

TEST_F(HistoryTest, RefusesAFolderOrADatabaseThatIsNotThere) {
  EXPECT_THROW(History(runs() / "nowhere"), FileError);
  try {
    history().query({});
    FAIL();
  } catch (const FileError& error) {
    EXPECT_EQ(error.thing(), (runs() / kHistoryFile).string());
    EXPECT_EQ(error.value(), "missing");
    EXPECT_NE(error.cure().find("history rebuild"), std::string::npos);
  }
  EXPECT_FALSE(fs::exists(runs() / kHistoryFile));
  std::ofstream(runs() / kHistoryFile).flush();
  EXPECT_THROW(history().query({}), FileError);  // empty: no list of no runs
}

TEST_F(HistoryTest, FindsARunByItsId) {
  add(made_run(1));
  EXPECT_EQ(history().find("run_000001").record.message, "message 1");
  EXPECT_THROW(history().find("run_000002"), UnusableInput);
}

}  // namespace
}  // namespace part_recipes
