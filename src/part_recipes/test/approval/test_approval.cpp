// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <thread>

#include "approval/approval.h"
#include "history/made_runs.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"
#include "temporary_folder.h"

namespace part_recipes {
namespace {

namespace fs = std::filesystem;

class AnApproval : public testing::Test {
 protected:
  AnApproval() { write_run(runs(), made_run(1)); }

  fs::path runs() const { return folder_.path(); }
  fs::path run() const { return runs() / "run_000001"; }
  fs::path file() const { return runs() / "run_000001.approval.json"; }

  TemporaryFolder folder_;
};

TEST_F(AnApproval, IsKeptWithNameNoteAndTimeAndTheLastCounts) {
  EXPECT_TRUE(approvals_of(run()).empty());
  EXPECT_NO_THROW(check_not_refused(run()));
  add_approval(run(), {false, "Jörg", "scratch <b>\"left\"</b>", "2026-11-25T12:00:00.000Z"});
  try {
    check_not_refused(run());
    ADD_FAILURE() << "a refused run may be worked";
  } catch (const scan_cell_common::Refused& error) {
    EXPECT_NE(std::string(error.what()).find("Jörg: scratch"), std::string::npos) << error.what();
  }
  add_approval(run(), {true, "Ada", "", "2026-11-25T12:01:00.000Z"});
  EXPECT_NO_THROW(check_not_refused(run()));
  const auto all = approvals_of(run());
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].note, "scratch <b>\"left\"</b>");
  EXPECT_EQ(all[0].time, "2026-11-25T12:00:00.000Z");
  EXPECT_EQ(all[1].name, "Ada");
}

TEST_F(AnApproval, IsNotLostWhereTwoProgramsWriteAtOnce) {
  constexpr int kEach = 50;
  const auto say = [&](const char* name) {
    for (int i = 0; i < kEach; ++i)
      add_approval(run(), {true, name, "", ""});
  };
  std::thread other(say, "Ada");
  say("Jörg");
  other.join();
  EXPECT_EQ(approvals_of(run()).size(), 2u * kEach);
}

TEST_F(AnApproval, NeedsAPersonAndARunThatWasAccepted) {
  EXPECT_THROW(add_approval(run(), {true, "", "", ""}), scan_cell_common::InvalidParameter);
  EXPECT_THROW(add_approval(runs() / "run_000002", {true, "Ada", "", ""}),
               scan_cell_common::FileError);
  RunRecord refused = made_run(3);
  refused.state = RunState::kRefused;
  write_run(runs(), refused);
  EXPECT_THROW(add_approval(runs() / "run_000003", {true, "Ada", "", ""}),
               scan_cell_common::Refused);
  EXPECT_NO_THROW(add_approval(runs() / "run_000003", {false, "Ada", "bent", ""}));
}

TEST_F(AnApproval, ThatIsBrokenLetsNothingPass) {
  for (const char* text : {"", "{", "[]", R"({"format":2,"approvals":[]})",
                           R"({"format":1,"approvals":[{"approved":1}]})"}) {
    scan_cell_common::save_text(file().string(), text);
    EXPECT_THROW(check_not_refused(run()), scan_cell_common::UnusableInput) << text;
    EXPECT_THROW(add_approval(run(), {true, "Ada", "", ""}), scan_cell_common::UnusableInput);
  }
}

}  // namespace
}  // namespace part_recipes
