// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <random>
#include <stdexcept>

#include "made_up_part.h"
#include "run/run_folder.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"

namespace part_recipes {
namespace {

namespace fs = std::filesystem;

/// Folders that count as runs.
std::vector<fs::path> runs_in(const fs::path& folder) {
  std::vector<fs::path> runs;
  if (!fs::exists(folder)) return runs;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().filename().string().front() != '.') runs.push_back(entry.path());
  }
  return runs;
}

/// A run of a few files.
fs::path make_run(const fs::path& runs) {
  RunFolder folder(runs, "frame");
  for (int i = 0; i < 5; ++i)
    scan_cell_common::save_text((folder.path() / ("file" + std::to_string(i))).string(), "text");
  RunRecord record;
  record.recipe_name = "frame";
  folder.write(record);
  return folder.seal();
}

TEST(ARunFolder, IsNoRunBeforeItIsSealed) {
  const TemporaryFolder temporary;
  {
    const RunFolder folder(temporary.path(), "frame");
    EXPECT_TRUE(runs_in(temporary.path()).empty());
  }
  EXPECT_TRUE(fs::is_empty(temporary.path())) << "it is removed";
}

TEST(ARunFolder, IsSealedWithTheHashOfEachFile) {
  const TemporaryFolder temporary;
  const fs::path run = make_run(temporary.path());
  const RunRecord record = load_run(run);
  EXPECT_EQ(record.id, run.filename());
  ASSERT_EQ(record.files.size(), 5u);
  // sha256sum of "text"
  EXPECT_EQ(record.files.at("file0").sha256,
            "982d9e3eb996f559e633f4d194def3761d909f5a3b647d1a851fead67c32c9d1");
  EXPECT_EQ(record.files.at("file0").bytes, 4u);
  EXPECT_NO_THROW(check_files(run, record));
}

TEST(ARunFolder, ThatWasChangedIsRefused) {
  const TemporaryFolder temporary;
  const auto said = [](const fs::path& run) -> std::string {
    try {
      check_files(run, load_run(run));
    } catch (const scan_cell_common::UnusableInput& error) {
      return error.value();
    }
    return "nothing";
  };
  const fs::path changed = make_run(temporary.path());
  scan_cell_common::save_text((changed / "file3").string(), "test");
  EXPECT_EQ(said(changed), "changed since the run");
  const fs::path less = make_run(temporary.path());
  fs::remove(less / "file3");
  EXPECT_EQ(said(less), "missing");
  const fs::path more = make_run(temporary.path());
  scan_cell_common::save_text((more / "file9").string(), "test");
  EXPECT_EQ(said(more), "not of this run");
}

TEST(ARunFolder, InAFolderThatCannotBeWrittenIsRefused) {
  const TemporaryFolder temporary;
  scan_cell_common::save_text((temporary.path() / "runs").string(), "a file");
  EXPECT_THROW(RunFolder(temporary.path() / "runs", "frame"), scan_cell_common::FileError);
}

TEST(ARunFolder, InAReadOnlyFolderIsRefusedByItsName) {
  const TemporaryFolder temporary;
  fs::permissions(temporary.path(), fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_EXIT(
      {
        drop_capabilities();
        try {
          make_run(temporary.path());
        } catch (const scan_cell_common::FileError& error) {
          const fs::path named = error.thing();
          _exit(named == temporary.path() || named.parent_path() == temporary.path() ? 42 : 1);
        }
        _exit(0);
      },
      testing::ExitedWithCode(42), "");
  EXPECT_TRUE(fs::is_empty(temporary.path()));
}

/// Makes a run in another process and kills that process `instant` after it has begun.
/// @return whether the run was made before
bool make_and_kill(const fs::path& runs, std::chrono::microseconds instant) {
  int ends[2] = {};
  if (pipe(ends) != 0) throw std::runtime_error("no pipe");
  const pid_t child = fork();
  if (child == 0) {
    if (write(ends[1], "b", 1) != 1) _exit(1);
    make_run(runs);
    _exit(0);
  }
  char begun = 0;
  EXPECT_EQ(read(ends[0], &begun, 1), 1);
  usleep(static_cast<useconds_t>(instant.count()));  // the instant is what is tried
  kill(child, SIGKILL);
  int status = 0;
  waitpid(child, &status, 0);
  close(ends[0]);
  close(ends[1]);
  EXPECT_TRUE(WIFSIGNALED(status) || WEXITSTATUS(status) == 0) << status;
  return WIFEXITED(status);
}

TEST(ARun, ThatIsKilledAtAnyInstantIsWholeOrNotThere) {
  const TemporaryFolder temporary;
  const fs::path runs = temporary.path() / "struck";
  std::mt19937 draw(1);
  std::uniform_real_distribution<double> part(0, 1);
  double longest = 1000;  // [us] follows what a run takes on this machine at this moment
  constexpr double kStep = 1.1;
  constexpr int kTimes = 200;
  std::size_t ended = 0;
  for (int i = 0; i < kTimes; ++i) {
    const std::chrono::microseconds instant(static_cast<int>(part(draw) * longest));
    const bool was_made = make_and_kill(runs, instant);
    ended += was_made ? 1 : 0;
    longest = was_made ? longest / kStep : longest * kStep;
  }
  const auto made = runs_in(runs);
  for (const fs::path& run : made)
    EXPECT_NO_THROW(check_files(run, load_run(run))) << run;
  EXPECT_GE(made.size(), ended) << "a run that ended is there";
  EXPECT_GT(ended, 0u);
  EXPECT_LT(made.size(), std::size_t{kTimes}) << "none was struck";
}

TEST(ARun, ThatTheDiskDoesNotTakeIsToldAndNotThere) {
  const TemporaryFolder temporary;
  const pid_t child = fork();
  if (child == 0) {
    signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{100, 100};  // [bytes] of a file: run.json is longer
    setrlimit(RLIMIT_FSIZE, &limit);
    try {
      make_run(temporary.path());
    } catch (const scan_cell_common::FileError& error) {
      _exit(fs::path(error.thing()).filename() == kRunFile ? 42 : 1);
    }
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(WEXITSTATUS(status), 42) << "run.json is named";
  EXPECT_TRUE(fs::is_empty(temporary.path()));
}

TEST(ARunRecord, ComesBackAsItWas) {
  const TemporaryFolder temporary;
  RunRecord record;
  record.id = "x";
  record.recipe_name = "größer <b>\"";
  record.state = RunState::kRefused;
  record.reason = "wrong_part";
  record.stages = {{"clean", {"clean_cloud", "--input", "a b"}, 2, 1.25}};
  record.tolerance = 0.0005;
  record.figures.scale = 1.0 / 3;
  record.figures.places = {{"left", 0.1}, {"right", std::nullopt}};
  record.files["a"] = {"00ff", 5000000000};
  record.again_of = "y";
  scan_cell_common::save_text((temporary.path() / kRunFile).string(), to_json(record));
  const RunRecord read = load_run(temporary.path());
  EXPECT_EQ(to_json(read), to_json(record));
  EXPECT_EQ(read.figures.scale, record.figures.scale);
  EXPECT_EQ(read.figures.places, record.figures.places);
  EXPECT_EQ(read.stages[0].command, record.stages[0].command);
  EXPECT_EQ(read.state, RunState::kRefused);
  EXPECT_FALSE(read.figures.rms);
}

TEST(ARunRecord, ThatIsBrokenOrNewerIsRefused) {
  const TemporaryFolder temporary;
  std::string newer = to_json({});
  newer.replace(newer.find("\"format\": 1"), 11, "\"format\": 9");
  for (const std::string& text : {std::string("{"), std::string("{}"), std::string("[]"), newer}) {
    scan_cell_common::save_text((temporary.path() / kRunFile).string(), text);
    EXPECT_THROW(load_run(temporary.path()), scan_cell_common::UnusableInput) << text;
  }
}

}  // namespace
}  // namespace part_recipes
