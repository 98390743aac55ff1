// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "history/history_rows.h"

#include <fmt/format.h>

#include <algorithm>

#include "history/run_columns.h"
#include "scan_cell_common/errors/errors.h"

namespace part_recipes {
namespace {

using scan_cell_common::Refused;
using scan_cell_common::UnusableInput;

constexpr int kFormat = 1;
constexpr int kApplication = 0x53436848;  // "SChH" in the file's header says whose it is

/// Each name followed by a text, all after a comma.
template <class Columns>
std::string names_of(const Columns& columns, const std::string& after) {
  std::string names;
  for (const auto& column : columns)
    names += std::string(", ") + column.name + after;
  return names;
}

/// All columns but the sequence, in the order of insert_run() and run_in().
std::string all_columns() {
  return "record_sha256, state, tolerance" + names_of(kTextColumns, "") +
         names_of(kFigureColumns, "");
}

std::int64_t pragma(const Database& database, const std::string& name) {
  Statement statement(database, "PRAGMA " + name);
  statement.next();
  return statement.integer(0);
}

std::string tables() {
  return "CREATE TABLE runs (sequence INTEGER PRIMARY KEY AUTOINCREMENT,"
         " record_sha256 TEXT NOT NULL, state TEXT NOT NULL, tolerance REAL" +
         names_of(kTextColumns, " TEXT NOT NULL") + names_of(kFigureColumns, " REAL") +
         ", UNIQUE (id));"
         "CREATE INDEX runs_of_recipe ON runs (recipe, sequence);"
         "CREATE TABLE places (run INTEGER NOT NULL REFERENCES runs (sequence) ON DELETE CASCADE,"
         " name TEXT NOT NULL, deviation REAL, PRIMARY KEY (run, name)) WITHOUT ROWID;" +
         fmt::format("PRAGMA application_id = {}; PRAGMA user_version = {}", kApplication, kFormat);
}

bool has_tables(const Database& database) {
  Statement statement(database, "SELECT count(*) FROM sqlite_schema");
  statement.next();
  return statement.integer(0) > 0;
}

/// The run, without its places.
HistoryRun run_in(const Statement& row) {
  HistoryRun run;
  RunRecord& record = run.record;
  int column = 0;
  run.sequence = row.integer(column++);
  ++column;  // record_sha256
  const std::string state = row.text(column++);
  for (const RunState known : {RunState::kAccepted, RunState::kRefused, RunState::kUnusable}) {
    if (to_string(known) == state) record.state = known;
  }
  record.tolerance = row.number(column++).value_or(0);
  for (const TextColumn& text : kTextColumns)
    record.*text.member = row.text(column++);
  for (const FigureColumn& figure : kFigureColumns)
    record.figures.*figure.member = row.number(column++);
  return run;
}

/// Adds the places of runs whose sequences rise.
void add_places(const Database& database, std::vector<HistoryRun>& runs) {
  if (runs.empty()) return;
  Statement places(
      database, "SELECT run, name, deviation FROM places WHERE run BETWEEN ? AND ? ORDER BY run");
  places.bind_integer(runs.front().sequence).bind_integer(runs.back().sequence);
  auto run = runs.begin();
  while (places.next()) {
    const std::int64_t sequence = places.integer(0);
    while (run != runs.end() && run->sequence < sequence)
      ++run;
    if (run == runs.end()) return;
    if (run->sequence == sequence) run->record.figures.places[places.text(1)] = places.number(2);
  }
}

/// The text as a pattern of LIKE, with its special characters escaped.
std::optional<std::string> pattern(const std::optional<std::string>& text) {
  if (!text) return std::nullopt;
  std::string result = "%";
  for (const char letter : *text) {
    if (letter == '%' || letter == '_' || letter == '\\') result += '\\';
    result += letter;
  }
  return result + "%";
}

}  // namespace

void prepare_history(Database& database, const std::string& cure) {
  Transaction transaction(database, Access::kWrite);
  if (!has_tables(database) && pragma(database, "application_id") == 0) database.execute(tables());
  check_history(database, cure);
  transaction.commit();
}

void check_history(const Database& database, const std::string& cure) {
  const std::string file = database.file().string();
  if (pragma(database, "application_id") != kApplication)
    throw Refused(file, "another program's database", "move it away, then " + cure);
  const std::int64_t format = pragma(database, "user_version");
  if (format > kFormat)
    throw UnusableInput(
        file, fmt::format("format {} of a newer version, this one reads {}", format, kFormat),
        "update the suite, or for this version " + cure);
}

void insert_run(const Database& database, const RunFile& run) {
  const RunRecord& record = run.record;
  static const std::string kInsert = [] {
    std::string marks = "?, ?, ?";
    for (std::size_t i = 0; i < kTextColumns.size() + kFigureColumns.size(); ++i)
      marks += ", ?";
    return fmt::format("INSERT INTO runs ({}) VALUES ({}) RETURNING sequence", all_columns(),
                       marks);
  }();
  Statement insert(database, kInsert);
  insert.bind_text(run.sha256).bind_text(to_string(record.state)).bind_number(record.tolerance);
  for (const TextColumn& text : kTextColumns)
    insert.bind_text(record.*text.member);
  for (const FigureColumn& figure : kFigureColumns)
    insert.bind_number(record.figures.*figure.member);
  insert.next();
  const std::int64_t sequence = insert.integer(0);
  insert.run();
  Statement place(database, "INSERT INTO places (run, name, deviation) VALUES (?, ?, ?)");
  for (const auto& [name, deviation] : record.figures.places) {
    place.bind_integer(sequence).bind_text(name).bind_number(deviation);
    place.run();
  }
}

std::string sha256_in_history(const Database& database, const std::string& id) {
  Statement statement(database, "SELECT record_sha256 FROM runs WHERE id = ?");
  statement.bind_text(id);
  return statement.next() ? statement.text(0) : std::string();
}

std::vector<HistoryRun> select_runs(Database& database, const HistoryFilter& filter) {
  Transaction one_state(database, Access::kRead);
  static const std::string kSelect =
      "SELECT sequence, " + all_columns() +
      " FROM runs WHERE (?1 IS NULL OR recipe = ?1) AND (?2 IS NULL OR state = ?2) AND (?3 IS NULL "
      "OR reason = ?3) "
      "AND (?4 IS NULL OR started >= ?4) AND (?5 IS NULL OR started <= ?5) AND (?6 IS NULL OR "
      "id || char(10) || recipe || char(10) || reason || char(10) || message || char(10) || host "
      "|| char(10) || note LIKE ?6 ESCAPE '\\') AND (?7 IS NULL OR id = ?7) ORDER BY sequence DESC "
      "LIMIT ?8";
  Statement select(database, kSelect);
  for (const auto& text : {filter.recipe, filter.state, filter.reason, filter.since, filter.until,
                           pattern(filter.text), filter.id})
    select.bind_text_or_null(text);
  select.bind_integer(filter.limit ? static_cast<std::int64_t>(*filter.limit) : -1);
  std::vector<HistoryRun> runs;
  while (select.next())
    runs.push_back(run_in(select));
  std::reverse(runs.begin(), runs.end());
  add_places(database, runs);
  one_state.commit();
  return runs;
}

std::map<std::string, std::int64_t> sequences(const Database& database) {
  Statement statement(database, "SELECT id, sequence FROM runs");
  std::map<std::string, std::int64_t> all;
  while (statement.next())
    all[statement.text(0)] = statement.integer(1);
  return all;
}

}  // namespace part_recipes
