// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <random>
#include <set>

#include "made_up_part.h"
#include "replay/job_folder.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"

namespace part_recipes {
namespace {

namespace fs = std::filesystem;
using std::chrono::seconds;

constexpr seconds kLongLease(3600);

std::vector<Job> some_jobs(std::size_t count) {
  std::vector<Job> jobs;
  for (std::size_t i = 0; i < count; ++i)
    jobs.push_back({"run" + std::to_string(i), "/recorded/run" + std::to_string(i), "/recipe"});
  return jobs;
}

TEST(AJob, IsGivenToOneWorker) {
  const TemporaryFolder temporary;
  const JobFolder folder(temporary.path());
  folder.add(some_jobs(2));
  const auto one = folder.claim(kLongLease);
  const auto other = folder.claim(kLongLease);
  ASSERT_TRUE(one && other);
  EXPECT_NE(one->id, other->id);
  EXPECT_EQ(one->run, fs::path("/recorded") / one->id);
  EXPECT_FALSE(folder.claim(kLongLease));
  folder.release(*one);
  EXPECT_EQ(folder.claim(kLongLease)->id, one->id);
}

TEST(AJob, OfAWorkerThatIsSilentIsGivenToAnother) {
  const TemporaryFolder temporary;
  const JobFolder folder(temporary.path());
  folder.add(some_jobs(1));
  const auto first = folder.claim(kLongLease);
  ASSERT_TRUE(first);
  // The worker's last sign of life was two hours ago.
  fs::last_write_time(temporary.path() / "claims" / first->id,
                      fs::file_time_type::clock::now() - std::chrono::hours(2));
  ASSERT_TRUE(folder.claim(kLongLease));
  EXPECT_FALSE(folder.claim(kLongLease)) << "it was claimed anew";
}

TEST(AJob, ThatTwoWorkersDidCountsOnce) {
  const TemporaryFolder temporary;
  const JobFolder folder(temporary.path());
  folder.add(some_jobs(1));
  const auto job = folder.claim(kLongLease);
  EXPECT_TRUE(folder.finish(*job, folder.runs() / "first"));
  EXPECT_FALSE(folder.finish(*job, folder.runs() / "second"));
  EXPECT_EQ(folder.result(job->id), folder.runs() / "first");
  EXPECT_FALSE(folder.claim(kLongLease));
}

TEST(AJob, ThatIsThereAlreadyStays) {
  const TemporaryFolder temporary;
  const JobFolder folder(temporary.path());
  folder.add(some_jobs(1));
  folder.finish(*folder.claim(kLongLease), folder.runs() / "first");
  folder.add(some_jobs(3));
  EXPECT_EQ(folder.jobs().size(), 3u);
  EXPECT_EQ(folder.result("run0"), folder.runs() / "first");
}

TEST(AJob, ThatIsBrokenIsNamed) {
  const TemporaryFolder temporary;
  const JobFolder folder(temporary.path());
  scan_cell_common::save_text((temporary.path() / "jobs/x.json").string(), "{");
  try {
    folder.jobs();
    FAIL() << "it was read";
  } catch (const scan_cell_common::UnusableInput& error) {
    EXPECT_EQ(fs::path(error.thing()).filename(), "x.json");
  }
}

/// Does jobs until none is left; each run is a folder.
[[noreturn]] void work(const fs::path& path) {
  const JobFolder folder(path);
  for (int i = 0; const auto job = folder.claim(seconds(0)); ++i) {
    const fs::path run = folder.runs() / (job->id + "_" + std::to_string(getpid()));
    fs::create_directory(run);
    if (!folder.finish(*job, run)) fs::remove(run);
  }
  _exit(0);
}

TEST(Jobs, AreEachDoneOnceThoughWorkersAreKilled) {
  const TemporaryFolder temporary;
  constexpr std::size_t kJobs = 100;
  const JobFolder folder(temporary.path());
  folder.add(some_jobs(kJobs));
  std::mt19937 draw(2);
  std::uniform_int_distribution<useconds_t> microseconds(0, 20000);
  for (int i = 0; i < 50; ++i) {
    std::vector<pid_t> workers;
    for (int k = 0; k < 3; ++k) {
      workers.push_back(fork());
      if (workers.back() == 0) work(temporary.path());
    }
    usleep(microseconds(draw));  // the instant is what is drawn
    kill(workers.front(), SIGKILL);
    usleep(microseconds(draw));
    kill(workers.back(), SIGKILL);
    kill(workers[1], SIGKILL);
    for (const pid_t worker : workers)
      waitpid(worker, nullptr, 0);
  }
  const pid_t last = fork();
  if (last == 0) work(temporary.path());
  waitpid(last, nullptr, 0);
  std::set<fs::path> results;
  for (const Job& job : folder.jobs()) {
    const auto result = folder.result(job.id);
    ASSERT_TRUE(result) << job.id << " was lost";
    EXPECT_TRUE(fs::exists(*result)) << *result;
    EXPECT_EQ(result->filename().string().rfind(job.id + "_", 0), 0u);
    results.insert(*result);
  }
  EXPECT_EQ(results.size(), kJobs);
}

}  // namespace
}  // namespace part_recipes
