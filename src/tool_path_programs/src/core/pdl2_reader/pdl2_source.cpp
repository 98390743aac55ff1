// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pdl2_reader/pdl2_source.h"

#include <filesystem>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/errors/text.h"

namespace tool_path_programs {
namespace {

using scan_cell_common::lower_case;

/// Whether a section of declarations begins here.
bool at_section(const TokenReader& reader) {
  for (const char* word : {"begin", "routine", "var", "const", "type", "import", "program"})
    if (reader.at_name(word)) return true;
  return reader.at_end();
}

bool is_listing(const SourceFile& file) {
  return lower_case(std::filesystem::path(file.name).extension().string()) == ".lsv";
}

}  // namespace

bool pdl2_word_moves(const std::string& word) {
  static const std::set<std::string> words = {"move", "movefly", "$tool", "$uframe", "$base"};
  return words.count(word) > 0;
}

Pdl2Source::Pdl2Source(const std::vector<SourceFile>& files) : files_(files) {
  for (std::size_t file = 0; file < files.size(); ++file) {
    tokens_.push_back(tokens_of(files[file], pdl2_rules()));
    scopes_.push_back(lower_case(std::filesystem::path(files[file].name).stem().string()) + "/");
  }
  for (std::size_t file = 0; file < files.size(); ++file)
    is_listing(files[file]) ? read_values(file) : read_program(file);
  if (!main_)
    throw scan_cell_common::UnusableInput(files.empty() ? "PDL2 program" : files.front().name,
                                          "no BEGIN of a program", "give the .pdl file");
  spread_motion();
}

TokenReader Pdl2Source::reader(std::size_t file, std::size_t position) const {
  TokenReader reader(files_[file], file, tokens_[file]);
  if (position > 0) reader.go_to(position);
  return reader;
}

const Pdl2Body* Pdl2Source::routine(const std::string& name, std::size_t from_file) const {
  const auto local = local_.find({from_file, name});
  if (local != local_.end()) return local->second;
  const auto global = global_.find(name);
  return global == global_.end() ? nullptr : global->second;
}

const Pdl2Variable* Pdl2Source::variable(const std::string& name, std::size_t file) const {
  const auto found = variables_.find(scopes_[file] + name);
  return found == variables_.end() ? nullptr : &found->second;
}

void Pdl2Source::read_program(std::size_t file) {
  TokenReader at = reader(file, 0);
  std::string name = files_[file].name;
  while (!at.at_end()) {
    if (at.accept("program")) {
      name = at.name();
      at.skip_line();
    } else if (at.accept("var")) {
      read_variables(at, file, nullptr);
    } else if (at.accept("routine")) {
      auto body = read_routine_head(at, file);
      if (!body) continue;
      read_body(at, *body);
      local_.insert({{file, lower_case(body->name)}, body.get()});
      global_.insert({lower_case(body->name), body.get()});
      bodies_.push_back(std::move(body));
    } else if (at.at_name("begin")) {
      auto body = std::make_unique<Pdl2Body>();
      body->name = name;
      body->file = file;
      read_body(at, *body);
      if (!main_ && file == 0) main_ = body.get();
      bodies_.push_back(std::move(body));
    } else {
      at.skip_line();
    }
  }
}

/// p1, p2 : POSITION EXPORTED FROM tools
void Pdl2Source::read_variables(TokenReader& at, std::size_t file, std::set<std::string>* locals) {
  for (; !at_section(at); at.skip_line()) {
    std::vector<std::string> names;
    while (at.peek().kind == TokenKind::kName) {
      names.push_back(lower_case(at.next().text));
      if (!at.accept(',')) break;
    }
    if (!at.accept(':')) continue;
    Pdl2Variable variable;
    while (!at.at_line_end()) {
      const bool from = at.at_name("from");
      const Token token = at.next();
      if (token.kind == TokenKind::kName && variable.type.empty())
        variable.type = lower_case(token.text);
      if (from && at.peek().kind == TokenKind::kName) variable.exporter = at.peek().text;
    }
    for (const std::string& name : names) {
      if (locals) locals->insert(name);
      variables_[scopes_[file] + name] = variable;
    }
  }
}

/// Reads up to BEGIN; null: the body is in another program.
std::unique_ptr<Pdl2Body> Pdl2Source::read_routine_head(TokenReader& at, std::size_t file) {
  auto body = std::make_unique<Pdl2Body>();
  body->name = at.name();
  body->file = file;
  bool elsewhere = false;
  while (!at.at_line_end()) {
    elsewhere = elsewhere || at.at_name("exported");
    const Token token = at.next();
    if (token.kind == TokenKind::kName) body->locals.insert(lower_case(token.text));
  }
  at.skip_line();
  if (elsewhere) return nullptr;
  while (!at.at_end() && !at.at_name("begin")) {
    if (at.accept("var"))
      read_variables(at, file, &body->locals);
    else if (at.at_name("routine"))
      return nullptr;
    else
      at.skip_line();
  }
  return body;
}

/// Reads from BEGIN past END.
void Pdl2Source::read_body(TokenReader& at, Pdl2Body& body) {
  at.accept("begin");
  body.begin = at.position();
  for (; !at.at_end() && !at.at_name("end"); at.skip_line())
    while (!at.at_line_end()) {
      const Token token = at.next();
      if (token.kind != TokenKind::kName) continue;
      const std::string word = lower_case(token.text);
      body.moves = body.moves || pdl2_word_moves(word);
      body.names.insert(word);
    }
  at.skip_line();
}

/// P1 POS Priv X:1 Y:2 Z:3 A:0 E:90 R:0 CNFG: ''
void Pdl2Source::read_values(std::size_t file) {
  TokenReader at = reader(file, 0);
  for (; !at.at_end(); at.skip_line()) {
    if (at.peek().kind != TokenKind::kName || at.peek_after().kind != TokenKind::kName) continue;
    const std::string name = lower_case(at.next().text);
    if (!at.at_name("pos") && !at.at_name("xtnd")) continue;
    while (!at.at_line_end() && !at.at_name("x"))
      at.next();
    Pdl2Value value;
    value.place = at.place();
    value.pose = read_pos(at);
    if (value.pose) data_[scopes_[file] + name] = value;
  }
}

/// Marks routines that move by a routine that they call.
void Pdl2Source::spread_motion() {
  std::map<std::string, std::vector<Pdl2Body*>> callers;
  std::vector<Pdl2Body*> moving;
  for (const auto& body : bodies_) {
    for (const std::string& name : body->names)
      if (global_.count(name) > 0) callers[name].push_back(body.get());
    if (body->moves) moving.push_back(body.get());
  }
  while (!moving.empty()) {
    const std::string name = lower_case(moving.back()->name);
    moving.pop_back();
    for (Pdl2Body* caller : callers[name])
      if (!caller->moves) {
        caller->moves = true;
        moving.push_back(caller);
      }
  }
}

}  // namespace tool_path_programs
