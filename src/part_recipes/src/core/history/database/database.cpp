// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "history/database/database.h"

#include <fmt/format.h>
#include <sqlite3.h>
#include <unistd.h>

#include <cctype>

#include "scan_cell_common/errors/errors.h"

namespace part_recipes {
namespace {

namespace fs = std::filesystem;

using scan_cell_common::FileError;
using scan_cell_common::Refused;
using scan_cell_common::UnusableInput;

constexpr int kBusyTimeout = 10000;  // [ms] a writer has it for some ms

bool is_writable(const fs::path& path) {
  return access(path.c_str(), W_OK) == 0;
}

/// URI of a file that nobody can change: SQLite neither locks it nor looks for a log beside it.
std::string immutable_uri(const fs::path& file) {
  std::string uri = "file:";
  for (const char letter : fs::absolute(file).string()) {
    const bool plain = std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '/';
    uri +=
        plain ? std::string(1, letter) : fmt::format("%{:02X}", static_cast<unsigned char>(letter));
  }
  return uri + "?immutable=1";
}

struct Opening {
  std::string name;
  int flags = 0;
};

Opening opening(const fs::path& file, Access access, const std::string& cure) {
  std::error_code none;
  const auto size = fs::file_size(file, none);
  const bool has_content = !none && size > 0;
  if (access == Access::kWrite) {
    const fs::path folder = file.parent_path();
    if (!is_writable(folder) || (fs::exists(file) && !is_writable(file)))
      throw FileError(folder.string(), "cannot be written", "check the folder's permissions");
    return {file.string(), SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE};
  }
  if (!has_content) throw FileError(file.string(), none ? "missing" : "empty", cure);
  const bool beside = is_writable(file.parent_path());
  if (beside && is_writable(file)) return {file.string(), SQLITE_OPEN_READWRITE};
  const auto log = fs::file_size(file.string() + "-wal", none);
  const bool is_whole = none || log == 0;
  if (beside || !is_whole) return {file.string(), SQLITE_OPEN_READONLY};
  return {immutable_uri(file), SQLITE_OPEN_READONLY | SQLITE_OPEN_URI};
}

}  // namespace

void Database::Close::operator()(sqlite3* database) const {
  sqlite3_close_v2(database);
}

Database::Database(const fs::path& file, Access access, const std::string& cure)
    : file_(file), cure_(cure) {
  const Opening how = opening(file, access, cure);
  sqlite3* opened = nullptr;
  const int code = sqlite3_open_v2(how.name.c_str(), &opened, how.flags, nullptr);
  database_.reset(opened);
  if (code != SQLITE_OK) fail(code);
  sqlite3_extended_result_codes(opened, 1);
  sqlite3_busy_timeout(opened, kBusyTimeout);
  // The log lets readers read on beside a writer; FULL brings each commit to the disk.
  execute(access == Access::kRead
              ? "PRAGMA query_only = ON"
              : "PRAGMA journal_mode = WAL; PRAGMA synchronous = FULL; PRAGMA foreign_keys = ON");
}

void Database::execute(const std::string& statements) {
  const int code = sqlite3_exec(handle(), statements.c_str(), nullptr, nullptr, nullptr);
  if (code != SQLITE_OK) fail(code);
}

void Database::fail(int code) const {
  const std::string why = handle() != nullptr ? sqlite3_errmsg(handle()) : sqlite3_errstr(code);
  constexpr int kPrimary = 0xff;  // extended codes have more above
  switch (code & kPrimary) {
    case SQLITE_CORRUPT:
    case SQLITE_NOTADB:
      throw UnusableInput(file_.string(), "damaged (" + why + ")", cure_);
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      throw Refused(file_.string(), "in use by another program", "end that one and try again");
    case SQLITE_FULL:
    case SQLITE_IOERR:
      throw FileError(file_.string(), why, "check the disk");
    case SQLITE_CANTOPEN:
    case SQLITE_PERM:
    case SQLITE_READONLY:
      throw FileError(file_.string(), why,
                      "check the permissions of the file and its folder, or copy the folder");
    default:
      throw UnusableInput(file_.string(), why, cure_);
  }
}

Transaction::Transaction(Database& database, Access access) : database_(database) {
  database_.execute(access == Access::kWrite ? "BEGIN IMMEDIATE" : "BEGIN");
}

Transaction::~Transaction() {
  // A failure here was reported before; SQLite rolls back the rest when it next opens the file.
  if (open_) sqlite3_exec(database_.handle(), "ROLLBACK", nullptr, nullptr, nullptr);
}

void Transaction::commit() {
  database_.execute("COMMIT");
  open_ = false;
}

}  // namespace part_recipes
