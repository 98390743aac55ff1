// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <fstream>
#include <thread>

#include "history/history.h"
#include "history/made_runs.h"
#include "history/run_folders.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"
#include "temporary_folder.h"

namespace part_recipes {
namespace {

namespace fs = std::filesystem;

using scan_cell_common::Error;
using scan_cell_common::FileError;
using scan_cell_common::Refused;
using scan_cell_common::UnusableInput;

constexpr std::size_t kPlaces = 3;  // of a made run

class HistoryFaults : public testing::Test {
 protected:
  fs::path runs() const { return folder_.path(); }
  fs::path file() const { return runs() / kHistoryFile; }
  History history() const { return History(runs()); }

  void add(std::uint64_t number) const { history().add(write_run(runs(), made_run(number))); }

  void add_many(std::uint64_t first, std::uint64_t count) const {
    for (std::uint64_t number = first; number < first + count; ++number)
      add(number);
  }

  /// Fills the history without the time that the disk takes for each add.
  void fill(std::uint64_t runs_of_it) const {
    for (std::uint64_t number = 1; number <= runs_of_it; ++number)
      write_run(runs(), made_run(number));
    history().rebuild();
  }

  std::size_t count() const { return history().query({}).size(); }

  /// Adds a run in a process that ends before the log is brought into the database.
  void leave_in_log(const std::string& id) const {
    EXPECT_EXIT(
        {
          auto* database = new Database(file(), Access::kWrite, "");
          insert_run(*database, read_run_file(runs() / id));
          _exit(0);
        },
        testing::ExitedWithCode(0), "");
  }

  /// Expects an UnusableInput that names the file and history rebuild.
  void expect_damaged() const {
    try {
      history().query({});
      ADD_FAILURE() << "not refused";
    } catch (const UnusableInput& error) {
      EXPECT_EQ(error.thing(), file().string());
      EXPECT_NE(error.cure().find("history rebuild"), std::string::npos) << error.what();
    }
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(HistoryFaults, ADamagedDatabaseIsRefusedAndRebuilt) {
  fill(100);
  const std::string whole = scan_cell_common::read_file(file().string());
  std::string no_header = whole;
  no_header.replace(0, 16, 16, 'x');
  std::string zeroed = whole.substr(0, 4096);
  zeroed.resize(whole.size());
  for (const std::string& damaged :
       {no_header, zeroed, whole.substr(0, whole.size() / 2), std::string("no database at all")}) {
    std::ofstream(file(), std::ios::binary) << damaged;
    expect_damaged();
    EXPECT_THROW(history().add(runs() / "run_000001"), UnusableInput);
    const Rebuilt rebuilt = history().rebuild();
    EXPECT_EQ(rebuilt.runs, 100u);
    EXPECT_NE(rebuilt.order_lost, "");
    EXPECT_EQ(count(), 100u);
  }
}

TEST_F(HistoryFaults, OfADatabaseWithABadPageNothingIsReadHalf) {
  constexpr std::size_t kPage = 4096;  // [bytes] SQLite's default
  fill(300);
  const std::string whole = scan_cell_common::read_file(file().string());
  std::size_t refused = 0;
  for (std::size_t page = kPage; page < whole.size(); page += kPage) {
    std::string damaged = whole;
    damaged.replace(page, kPage, kPage, '\0');
    std::ofstream(file(), std::ios::binary) << damaged;
    try {
      const auto found = history().query({});
      ASSERT_EQ(found.size(), 300u) << page;
      for (const HistoryRun& run : found)
        ASSERT_EQ(run.record.figures.places.size(), kPlaces) << page;
    } catch (const UnusableInput&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 10u);
}

TEST_F(HistoryFaults, ADatabaseOfANewerVersionIsRefusedByItsFormat) {
  add(1);
  Database(file(), Access::kWrite, "").execute("PRAGMA user_version = 99");
  const auto expect_refused = [this](const auto& call) {
    try {
      call();
      ADD_FAILURE() << "not refused";
    } catch (const UnusableInput& error) {
      EXPECT_EQ(error.thing(), file().string());
      EXPECT_NE(error.value().find("format 99"), std::string::npos) << error.what();
    }
  };
  expect_refused([this] { history().query({}); });
  expect_refused([this] { history().add(runs() / "run_000001"); });
  EXPECT_EQ(history().rebuild().runs, 1u);
  EXPECT_EQ(count(), 1u);
}

TEST_F(HistoryFaults, ADatabaseOfAnotherProgramIsLeftAlone) {
  write_run(runs(), made_run(1));
  Database(file(), Access::kWrite, "").execute("CREATE TABLE theirs (value)");
  EXPECT_THROW(history().query({}), Refused);
  EXPECT_THROW(history().add(runs() / "run_000001"), Refused);
  EXPECT_THROW(history().rebuild(), Refused);
  Statement(Database(file(), Access::kRead, ""), "SELECT value FROM theirs").next();
}

TEST_F(HistoryFaults, ADatabaseThatAnotherProgramReadsIsNotReplaced) {
  add(1);
  Database theirs(file(), Access::kRead, "");
  const Transaction reading(theirs, Access::kRead);
  Statement(theirs, "SELECT count(*) FROM runs").next();
  EXPECT_THROW(history().rebuild(), Refused);
  EXPECT_EQ(count(), 1u);
}

TEST_F(HistoryFaults, LeftoversOfARebuildThatWasKilledDoNotMatter) {
  add(1);
  for (const char* name : {".history.sqlite.new", ".history.sqlite.new-wal",
                           "history.sqlite-journal", ".history.sqlite.new-shm"})
    std::ofstream(runs() / name) << "half";
  EXPECT_EQ(history().rebuild().runs, 1u);
  EXPECT_EQ(count(), 1u);
}

TEST_F(HistoryFaults, ReadersSeeWholeRunsWhileOneWrites) {
  add(1);
  constexpr std::uint64_t kRuns = 150;
  std::atomic<bool> done{false};
  const auto read = [&] {
    std::size_t before = 1;
    for (bool is_last = false; !is_last;) {
      is_last = done;
      const auto found = history().query({});
      EXPECT_GE(found.size(), before);
      before = found.size();
      for (const HistoryRun& run : found)
        EXPECT_EQ(run.record.figures.places.size(), kPlaces);
    }
    EXPECT_EQ(before, kRuns + 1);
  };
  std::vector<std::thread> readers;
  for (int i = 0; i < 3; ++i)
    readers.emplace_back(read);
  add_many(2, kRuns);
  done = true;
  for (std::thread& reader : readers)
    reader.join();
}

TEST_F(HistoryFaults, WritersAndARebuildLoseNothing) {
  std::vector<std::thread> writers;
  for (std::uint64_t first : {0, 1000})
    writers.emplace_back([this, first] { add_many(first, 60); });
  for (int i = 0; i < 5; ++i)
    history().rebuild();
  for (std::thread& writer : writers)
    writer.join();
  EXPECT_EQ(count(), 120u);
  EXPECT_TRUE(history().left_out().empty());
}

TEST_F(HistoryFaults, TheLogOfALostDatabaseDoesNotReachTheNewOne) {
  constexpr std::uint64_t kRuns = 200;
  fill(50);
  write_run(runs(), made_run(51));
  leave_in_log("run_000051");
  for (std::uint64_t number = 52; number <= kRuns; ++number)
    write_run(runs(), made_run(number));
  fs::resize_file(file(), 0);
  const Rebuilt rebuilt = history().rebuild();
  EXPECT_EQ(rebuilt.order_lost, "empty");
  EXPECT_EQ(rebuilt.runs, kRuns);
  EXPECT_EQ(count(), kRuns);
  Database database(file(), Access::kRead, "");
  Statement check(database, "PRAGMA integrity_check");
  ASSERT_TRUE(check.next());
  EXPECT_EQ(check.text(0), "ok");
}

/// Runs `check` in a process for which the folder is read-only, and reports what it throws.
template <class Check>
void in_read_only(const fs::path& runs, const Check& check) {
  fs::permissions(runs, fs::perms::owner_read | fs::perms::owner_exec);
  for (const auto& entry : fs::directory_iterator(runs)) {
    if (entry.is_regular_file()) fs::permissions(entry.path(), fs::perms::owner_read);
  }
  EXPECT_EXIT(
      {
        drop_capabilities();
        try {
          check();
        } catch (const std::exception& error) {
          std::fprintf(stderr, "%s\n", error.what());
          _exit(1);
        }
        _exit(testing::Test::HasFailure() ? 1 : 0);
      },
      testing::ExitedWithCode(0), "");
  fs::permissions(runs, fs::perms::owner_all);
}

TEST_F(HistoryFaults, AReadOnlyFolderIsReadAndNotWritten) {
  const TemporaryFolder odd;
  const fs::path named = odd.path() / "50% ü #1?";
  fs::create_directory(named);
  History(named).add(write_run(named, made_run(1)));
  write_run(named, made_run(2));
  in_read_only(named, [&named] {
    EXPECT_EQ(History(named).query({}).size(), 1u);
    EXPECT_EQ(History(named).left_out().size(), 1u);
    for (const bool rebuild : {false, true}) {
      try {
        if (rebuild) {
          History(named).rebuild();
        } else {
          History(named).add(named / "run_000002");
        }
        ADD_FAILURE() << "written";
      } catch (const FileError& error) {
        EXPECT_EQ(error.thing(), named.string());
        EXPECT_NE(error.cure().find("permissions"), std::string::npos);
      }
    }
  });
  EXPECT_EQ(History(named).query({}).size(), 1u);
}

TEST_F(HistoryFaults, AReadOnlyFolderWithALogIsReadWholeOrNotAtAll) {
  add(1);
  write_run(runs(), made_run(2));
  leave_in_log("run_000002");
  ASSERT_GT(fs::file_size(file().string() + "-wal"), 0u);
  in_read_only(runs(), [this] { EXPECT_EQ(count(), 2u); });
  fs::remove(file().string() + "-shm");
  in_read_only(runs(), [this] { EXPECT_THROW(count(), FileError); });
}

}  // namespace
}  // namespace part_recipes
