// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "replay/job_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <iterator>
#include <nlohmann/json.hpp>

#include "disk/to_disk.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"

namespace part_recipes {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

using scan_cell_common::FileError;

/// Name of the claiming worker.
std::string worker() {
  char host[256] = {};  // HOST_NAME_MAX is 64
  gethostname(host, sizeof(host) - 1);
  return fmt::format("{} {}", host, getpid());
}

Job job_in(const fs::path& file) {
  const std::string text = scan_cell_common::read_file(file.string());
  try {
    const Json all = Json::parse(text);
    return {file.stem().string(), all.at("run").get<std::string>(),
            all.at("recipe").get<std::string>()};
  } catch (const nlohmann::json::exception& error) {
    throw scan_cell_common::UnusableInput(file.string(), error.what(), "remove it");
  }
}

/// Names of the JSON files in a folder, sorted.
std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  try {
    for (const auto& entry : fs::directory_iterator(folder)) {
      if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
    }
  } catch (const fs::filesystem_error& error) {
    throw_file_error(error);
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

JobFolder::JobFolder(fs::path folder) : folder_(fs::absolute(folder)) {
  try {
    for (const char* name : {"jobs", "claims", "done", "runs"})
      fs::create_directories(folder_ / name);
  } catch (const fs::filesystem_error& error) {
    throw_file_error(error);
  }
}

fs::path JobFolder::job_of(const std::string& id) const {
  return folder_ / "jobs" / (id + ".json");
}

fs::path JobFolder::done_of(const std::string& id) const {
  return folder_ / "done" / (id + ".json");
}

void JobFolder::add(const std::vector<Job>& jobs) const {
  for (const Job& job : jobs) {
    const fs::path file = job_of(job.id);
    if (fs::exists(file)) continue;
    const Json all = {{"run", fs::absolute(job.run).string()},
                      {"recipe", fs::absolute(job.recipe).string()}};
    scan_cell_common::save_text(file.string(), all.dump() + "\n");
  }
}

std::vector<std::string> JobFolder::ids() const {
  return names_in(folder_ / "jobs");
}

std::vector<std::string> JobFolder::open_ids() const {
  const std::vector<std::string> all = ids(), done = names_in(folder_ / "done");
  std::vector<std::string> open;
  std::set_difference(all.begin(), all.end(), done.begin(), done.end(), std::back_inserter(open));
  return open;
}

std::vector<Job> JobFolder::jobs() const {
  std::vector<Job> jobs;
  for (const std::string& id : ids())
    jobs.push_back(job_in(job_of(id)));
  return jobs;
}

bool JobFolder::take(const std::string& id, std::chrono::seconds lease) const {
  const fs::path file = claim_of(id);
  std::error_code failure;
  const auto touched = fs::last_write_time(file, failure);
  if (!failure) {
    if (fs::file_time_type::clock::now() - touched < lease) return false;
    // Of several workers that find it free, one renames it.
    const fs::path old = file.string() + "." + std::to_string(getpid());
    fs::rename(file, old, failure);
    if (failure) return false;
    fs::remove(old, failure);
  }
  const int claim = open(file.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0644);
  if (claim < 0) {
    if (errno == EEXIST) return false;
    throw FileError(file.string(), std::strerror(errno), "check the folder and its permissions");
  }
  const std::string name = worker();
  const bool written = write(claim, name.data(), name.size()) >= 0;
  close(claim);
  return written;
}

std::optional<Job> JobFolder::claim(const std::string& id, std::chrono::seconds lease) const {
  if (fs::exists(done_of(id))) return std::nullopt;
  const Job job = job_in(job_of(id));
  if (!take(id, lease)) return std::nullopt;
  if (!fs::exists(done_of(id))) return job;  // nobody finished it meanwhile
  release(job);
  return std::nullopt;
}

std::optional<Job> JobFolder::claim(std::chrono::seconds lease) const {
  for (const std::string& id : open_ids()) {
    if (auto job = claim(id, lease)) return job;
  }
  return std::nullopt;
}

void JobFolder::touch(const Job& job) const {
  std::error_code gone;  // another worker took it; finish() decides between both
  fs::last_write_time(claim_of(job.id), fs::file_time_type::clock::now(), gone);
}

void JobFolder::release(const Job& job) const {
  std::error_code gone;
  fs::remove(claim_of(job.id), gone);
}

bool JobFolder::finish(const Job& job, const fs::path& run) const {
  const Json all = {{"run", run.filename().string()}, {"worker", worker()}};
  const fs::path draft = folder_ / "claims" / fmt::format("{}.{}.done", job.id, getpid());
  scan_cell_common::save_text(draft.string(), all.dump() + "\n");
  std::error_code failure;
  fs::create_hard_link(draft, done_of(job.id), failure);
  std::error_code gone;
  fs::remove(draft, gone);
  if (failure && failure != std::errc::file_exists)
    throw FileError(done_of(job.id).string(), failure.message(),
                    "use a file system with hard links");
  release(job);
  return !failure;
}

std::optional<fs::path> JobFolder::result(const std::string& id) const {
  if (!fs::exists(done_of(id))) return std::nullopt;
  const std::string text = scan_cell_common::read_file(done_of(id).string());
  try {
    return runs() / Json::parse(text).at("run").get<std::string>();
  } catch (const nlohmann::json::exception& error) {
    throw scan_cell_common::UnusableInput(done_of(id).string(), error.what(), "remove it");
  }
}

}  // namespace part_recipes
