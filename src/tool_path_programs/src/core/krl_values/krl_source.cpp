// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "krl_values/krl_source.h"

#include <filesystem>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/errors/text.h"

namespace tool_path_programs {
namespace {

using scan_cell_common::lower_case;

const LexicalRules& rules() {
  static const LexicalRules rules{{";"}, "\"'", "$#"};
  return rules;
}

}  // namespace

bool krl_word_moves(const std::string& word) {
  static const std::set<std::string> words = {
      "ptp",     "lin",        "circ",     "sptp",     "slin",      "scirc",     "spl",
      "ptp_rel", "lin_rel",    "circ_rel", "sptp_rel", "slin_rel",  "scirc_rel", "spl_rel",
      "spline",  "ptp_spline", "$tool",    "$base",    "$ipo_mode", "fdat_act",  "bas"};
  return words.count(word) > 0;
}

KrlSource::KrlSource(const std::vector<SourceFile>& files) : files_(files) {
  for (std::size_t file = 0; file < files.size(); ++file) {
    tokens_.push_back(tokens_of(files[file], rules()));
    scopes_.push_back(lower_case(std::filesystem::path(files[file].name).stem().string()) + "/");
  }
  for (std::size_t file = 0; file < files.size(); ++file) {
    find_routines(file);
    read_data(file);
  }
  spread_motion();
  if (routines_.empty())
    throw scan_cell_common::UnusableInput(files.empty() ? "KRL program" : files.front().name,
                                          "no DEF", "give the .src file");
}

TokenReader KrlSource::reader(std::size_t file, std::size_t position) const {
  TokenReader reader(files_[file], file, tokens_[file]);
  if (position > 0) reader.go_to(position);
  return reader;
}

const KrlRoutineText& KrlSource::main() const {
  return *routines_.front();
}

const KrlRoutineText* KrlSource::routine(const std::string& name, std::size_t from_file) const {
  const auto local = local_.find({from_file, name});
  if (local != local_.end()) return local->second;
  const auto global = global_.find(name);
  return global == global_.end() ? nullptr : global->second;
}

void KrlSource::find_routines(std::size_t file) {
  for (TokenReader at = reader(file, 0); !at.at_end(); at.skip_line()) {
    at.accept("global");
    if (at.at_name("def") || at.at_name("deffct")) read_head(at, file);
  }
}

/// DEF name ( ... ), or DEFFCT type name ( ... )
void KrlSource::read_head(TokenReader& at, std::size_t file) {
  at.next();
  std::string name = at.name();
  if (at.peek().kind == TokenKind::kName) name = at.name();
  auto routine = std::make_unique<KrlRoutineText>();
  routine->name = name;
  routine->file = file;
  while (!at.at_line_end()) {
    const Token token = at.next();
    if (token.kind != TokenKind::kName) continue;
    const std::string word = lower_case(token.text);
    routine->gives_back = routine->gives_back || word == "out";
    routine->parameters.push_back(word);
  }
  at.skip_line();
  routine->begin = at.position();
  find_motion(*routine);
  local_.insert({{file, lower_case(name)}, routine.get()});
  global_.insert({lower_case(name), routine.get()});
  routines_.push_back(std::move(routine));
  at.go_to(routines_.back()->begin - 1);  // the end of the routine's head, which the caller skips
}

void KrlSource::find_motion(KrlRoutineText& routine) {
  TokenReader at = reader(routine.file, routine.begin);
  for (; !at.at_end() && !at.at_name("end") && !at.at_name("endfct"); at.skip_line()) {
    while (!at.at_line_end()) {
      const Token token = at.next();
      if (token.kind != TokenKind::kName) continue;
      const std::string word = lower_case(token.text);
      routine.moves = routine.moves || krl_word_moves(word);
      if (at.at_symbol('(')) routine.calls.insert(word);
    }
  }
}

/// Marks routines that move by a routine that they call.
void KrlSource::spread_motion() {
  std::map<std::string, std::vector<KrlRoutineText*>> callers;
  std::vector<KrlRoutineText*> moving;
  for (const auto& routine : routines_) {
    for (const std::string& name : routine->calls)
      callers[name].push_back(routine.get());
    if (routine->moves) moving.push_back(routine.get());
  }
  while (!moving.empty()) {
    const std::string name = lower_case(moving.back()->name);
    moving.pop_back();
    for (KrlRoutineText* caller : callers[name])
      if (!caller->moves) {
        caller->moves = true;
        moving.push_back(caller);
      }
  }
}

void KrlSource::read_data(std::size_t file) {
  TokenReader at = reader(file, 0);
  while (!at.at_end() && !at.at_name("defdat"))
    at.skip_line();
  at.skip_line();
  for (; !at.at_end() && !at.at_name("enddat"); at.skip_line())
    read_declaration(at, file);
}

/// DECL GLOBAL E6POS XP1={X 1,...}, or XP1={...} for an array's element.
void KrlSource::read_declaration(TokenReader& at, std::size_t file) {
  if (at.peek().kind != TokenKind::kName || at.at_name("ext") || at.at_name("extfct")) return;
  bool global = scopes_[file] == "$config/";
  while (at.peek_after().kind == TokenKind::kName) {
    global = global || at.at_name("global");
    at.next();
  }
  while (at.peek().kind == TokenKind::kName) {
    const std::string name = read_variable(at);
    KrlValue value{{}, {}, at.place()};
    if (!at.accept('=')) return;
    value = read_value(at);
    data_[scopes_[file] + name] = value;
    if (global) data_.insert({name, value});
    if (!at.accept(',')) return;
  }
}

}  // namespace tool_path_programs
