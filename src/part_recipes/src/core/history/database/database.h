// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace part_recipes {

/// What a database is opened for.
enum class Access {
  kRead,   //!< many at a time, also if nothing can be written
  kWrite,  //!< one at a time, beside readers; makes a missing database
};

/// An open SQLite database. Its errors, also those of its statements: scan_cell_common::FileError
/// if disk or permissions fail, ...::Refused if another program keeps it longer than 10 s,
/// ...::UnusableInput for all else, such as a file that is damaged or not a database; each names
/// the file.
class Database {
 public:
  /// Opens it.
  /// @param cure for a damaged or missing file
  /// @throw as above; FileError also if the file is missing or cannot be written
  Database(const std::filesystem::path& file, Access access, const std::string& cure);

  /// Runs statements that have neither values nor results.
  void execute(const std::string& statements);

  sqlite3* handle() const { return database_.get(); }
  const std::filesystem::path& file() const { return file_; }

  /// @param code of SQLite, no success
  [[noreturn]] void fail(int code) const;

 private:
  struct Close {
    void operator()(sqlite3* database) const;
  };

  std::filesystem::path file_;
  std::string cure_;
  std::unique_ptr<sqlite3, Close> database_;
};

/// A prepared statement. The database must outlive it.
class Statement {
 public:
  Statement(const Database& database, std::string_view text);

  /// Binds the next value, from the first on.
  Statement& bind_text(std::string_view text);
  Statement& bind_text_or_null(const std::optional<std::string>& text);
  Statement& bind_integer(std::int64_t number);
  Statement& bind_number(const std::optional<double>& number);  ///< none or not a number: NULL

  /// Goes to the next row. Returns false at the end.
  bool next();

  /// Runs the statement to its end. It is then ready for other values.
  void run();

  std::string text(int column) const;
  std::int64_t integer(int column) const;
  std::optional<double> number(int column) const;  //!< none: NULL

 private:
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const;
  };

  void check(int code) const;

  const Database& database_;
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
  int bound_ = 0;
};

/// All or nothing: what was written is rolled back unless commit() was reached.
class Transaction {
 public:
  /// @param access kWrite: nobody else may write until it ends; kRead: sees one state of the
  /// database
  Transaction(Database& database, Access access);
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;

  void commit();

 private:
  Database& database_;
  bool open_ = true;
};

}  // namespace part_recipes
