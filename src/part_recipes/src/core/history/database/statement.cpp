// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <sqlite3.h>

#include "history/database/database.h"

namespace part_recipes {

void Statement::Finalize::operator()(sqlite3_stmt* statement) const {
  sqlite3_finalize(statement);  // repeats an error that was told before
}

Statement::Statement(const Database& database, std::string_view text) : database_(database) {
  sqlite3_stmt* prepared = nullptr;
  check(sqlite3_prepare_v2(database.handle(), text.data(), static_cast<int>(text.size()), &prepared,
                           nullptr));
  statement_.reset(prepared);
}

void Statement::check(int code) const {
  if (code != SQLITE_OK) database_.fail(code);
}

Statement& Statement::bind_text(std::string_view text) {
  // A null pointer would be NULL.
  const char* const start = text.data() != nullptr ? text.data() : "";
  check(sqlite3_bind_text64(statement_.get(), ++bound_, start, text.size(), SQLITE_TRANSIENT,
                            SQLITE_UTF8));
  return *this;
}

Statement& Statement::bind_integer(std::int64_t number) {
  check(sqlite3_bind_int64(statement_.get(), ++bound_, number));
  return *this;
}

Statement& Statement::bind_number(const std::optional<double>& number) {
  ++bound_;
  check(number ? sqlite3_bind_double(statement_.get(), bound_, *number)
               : sqlite3_bind_null(statement_.get(), bound_));
  return *this;
}

Statement& Statement::bind_text_or_null(const std::optional<std::string>& text) {
  if (text) return bind_text(*text);
  check(sqlite3_bind_null(statement_.get(), ++bound_));
  return *this;
}

bool Statement::next() {
  const int code = sqlite3_step(statement_.get());
  if (code == SQLITE_ROW) return true;
  if (code != SQLITE_DONE) database_.fail(code);
  return false;
}

void Statement::run() {
  while (next()) {
  }
  check(sqlite3_reset(statement_.get()));
  bound_ = 0;
}

std::string Statement::text(int column) const {
  const auto* const start =
      reinterpret_cast<const char*>(sqlite3_column_text(statement_.get(), column));
  const int bytes = sqlite3_column_bytes(statement_.get(), column);
  return start != nullptr ? std::string(start, static_cast<std::size_t>(bytes)) : std::string();
}

std::int64_t Statement::integer(int column) const {
  return sqlite3_column_int64(statement_.get(), column);
}

std::optional<double> Statement::number(int column) const {
  if (sqlite3_column_type(statement_.get(), column) == SQLITE_NULL) return std::nullopt;
  return sqlite3_column_double(statement_.get(), column);
}

}  // namespace part_recipes
