// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "approval/approval.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "disk/folder_lock.h"
#include "record/run_record.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"

namespace part_recipes {
namespace {

namespace fs = std::filesystem;

using Json = nlohmann::ordered_json;

constexpr int kApprovalFormat = 1;

fs::path approval_file(const fs::path& run) {
  return run.parent_path() / (run.filename().string() + ".approval.json");
}

std::vector<Approval> parse_approvals(const std::string& text) {
  const Json all = Json::parse(text);
  if (all.at("format").get<int>() != kApprovalFormat) throw std::runtime_error("another format");
  std::vector<Approval> approvals;
  for (const Json& said : all.at("approvals"))
    approvals.push_back({said.at("approved").get<bool>(), said.at("name").get<std::string>(),
                         said.at("note").get<std::string>(), said.at("time").get<std::string>()});
  return approvals;
}

std::string to_json(const std::vector<Approval>& approvals) {
  constexpr int kIndent = 2;
  Json all = {{"format", kApprovalFormat}, {"approvals", Json::array()}};
  for (const Approval& said : approvals)
    all["approvals"].push_back({{"approved", said.approved},
                                {"name", said.name},
                                {"note", said.note},
                                {"time", said.time}});
  return all.dump(kIndent, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

std::vector<Approval> approvals_of(const fs::path& run) {
  const fs::path file = approval_file(run);
  if (!fs::exists(file)) return {};
  const std::string text = scan_cell_common::read_file(file.string());
  try {
    return parse_approvals(text);
  } catch (const std::exception& error) {
    throw scan_cell_common::UnusableInput(file.string(), error.what(),
                                          "check it: it was edited, or a newer version wrote it");
  }
}

void add_approval(const fs::path& run, const Approval& approval) {
  if (approval.name.empty())
    throw scan_cell_common::InvalidParameter("name", "empty", "say who approves or refuses");
  const RunRecord record = load_run(run);
  if (approval.approved && record.state != RunState::kAccepted)
    throw scan_cell_common::Refused("run " + record.id, to_string(record.state),
                                    "only an accepted path can be approved: " + record.message);
  const FolderLock lock(run, FolderLock::Kind::kAlone);
  std::vector<Approval> all = approvals_of(run);
  all.push_back(approval);
  scan_cell_common::save_text(approval_file(run).string(), to_json(all));
}

void check_not_refused(const fs::path& run) {
  const std::vector<Approval> all = approvals_of(run);
  if (all.empty() || all.back().approved) return;
  const Approval& last = all.back();
  throw scan_cell_common::Refused(
      "run " + run.filename().string(),
      fmt::format("refused by {}{}", last.name, last.note.empty() ? "" : ": " + last.note),
      "approve it, or scan the part again");
}

}  // namespace part_recipes
