// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <random>
#include <set>

#include "history/history.h"
#include "history/made_runs.h"
#include "scan_cell_common/errors/text.h"

namespace part_recipes {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kKillsAFolder = 50;

/// Number of kills: 50, or HISTORY_KILLS.
std::uint64_t kills() {
  const char* const told = std::getenv("HISTORY_KILLS");
  return told != nullptr ? scan_cell_common::parse_count(told).value() : kKillsAFolder;
}

/// Adds runs from `first` on, and rebuilds now and then, until it is killed. Reports each number as
/// soon as add() has returned.
[[noreturn]] void add_until_killed(const fs::path& runs, std::uint64_t first, int pipe) {
  const History history(runs);
  constexpr std::uint64_t kRebuildEach = 7;
  for (std::uint64_t number = first;; ++number) {
    history.add(write_run(runs, made_run(number)));
    if (write(pipe, &number, sizeof number) != sizeof number) _exit(1);
    if (number % kRebuildEach == 0) history.rebuild();
  }
}

/// Lets a process add runs, and kills it at a random instant after it has reported some.
/// @return the reported numbers
std::vector<std::uint64_t> add_and_kill(const fs::path& runs, std::uint64_t first,
                                        std::mt19937_64& random) {
  constexpr std::uint64_t kMostBefore = 10;  // a rebuild is among them
  constexpr useconds_t kLongest = 40000;     // [us] an add and a rebuild take less
  int ends[2] = {};
  if (pipe(ends) != 0) throw std::runtime_error("no pipe");
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    try {
      add_until_killed(runs, first, ends[1]);
    } catch (const std::exception& error) {
      std::fprintf(stderr, "%s\n", error.what());
      _exit(1);
    }
  }
  close(ends[1]);
  std::vector<std::uint64_t> told;
  const auto read_one = [&] {
    std::uint64_t number = 0;
    const bool is_there = read(ends[0], &number, sizeof number) == sizeof number;
    if (is_there) told.push_back(number);
    return is_there;
  };
  for (std::uint64_t before = random() % kMostBefore; before > 0 && read_one(); --before) {
  }
  usleep(static_cast<useconds_t>(random() % kLongest));  // the instant is what is tried
  kill(child, SIGKILL);
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status)) << "ended by itself";
  while (read_one()) {
  }
  close(ends[0]);
  return told;
}

/// Expects that every reported run is there once, and none is half written.
void expect_whole(const fs::path& runs, const std::set<std::uint64_t>& told) {
  if (!fs::exists(runs / kHistoryFile)) {  // killed before the first was added
    EXPECT_TRUE(told.empty());
    return;
  }
  if (told.empty()) return;
  std::set<std::uint64_t> found;
  for (const HistoryRun& run : History(runs).query({})) {
    const auto number = scan_cell_common::parse_count(run.record.id.substr(4)).value();
    EXPECT_TRUE(found.insert(number).second) << run.record.id << " twice";
    const RunRecord made = made_run(number);
    EXPECT_EQ(run.record.message, made.message);
    EXPECT_EQ(run.record.figures.rms, made.figures.rms);
    EXPECT_EQ(run.record.figures.places, made.figures.places);
  }
  for (const std::uint64_t number : told)
    EXPECT_EQ(found.count(number), 1u) << "lost: " << number;
  const Database database(runs / kHistoryFile, Access::kRead, "");
  Statement check(database, "PRAGMA integrity_check");
  ASSERT_TRUE(check.next());
  EXPECT_EQ(check.text(0), "ok");
}

TEST(HistoryKills, NoRunThatWasAddedIsLostWhereTheProgramIsKilled) {
  std::mt19937_64 random(20261125);
  std::uint64_t amid = 0, all = 0;
  for (std::uint64_t done = 0; done < kills();) {
    const TemporaryFolder folder;
    std::set<std::uint64_t> told;
    for (std::uint64_t i = 0; i < kKillsAFolder && done < kills(); ++i, ++done) {
      const std::uint64_t first = 1000 * i;
      const auto now = add_and_kill(folder.path(), first, random);
      told.insert(now.begin(), now.end());
      expect_whole(folder.path(), told);
      if (HasFailure()) FAIL() << "at kill " << done;
      const std::uint64_t next = now.empty() ? first : now.back() + 1;
      amid += fs::exists(folder.path() / made_run(next).id) ? 1 : 0;
    }
    all += told.size();
  }
  EXPECT_GT(amid, 0u) << "no kill came between a run and its row";
  std::printf("%lu kills, %lu of them between a run and its row; %lu runs added\n",
              static_cast<unsigned long>(kills()), static_cast<unsigned long>(amid),
              static_cast<unsigned long>(all));
}

}  // namespace
}  // namespace part_recipes
