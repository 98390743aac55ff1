// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "rapid_reader/source/rapid_source.h"

#include "rapid_reader/source/rapid_values.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/errors/text.h"

namespace tool_path_programs {
namespace {

using scan_cell_common::lower_case;

bool at_declaration(const TokenReader& reader) {
  return reader.at_name("CONST") || reader.at_name("PERS") || reader.at_name("VAR");
}

void pass_over_statement(TokenReader& reader) {
  while (!reader.at_end() && !reader.at_symbol(';'))
    reader.next();
  reader.accept(';');
}

/// Where each element of a list begins.
std::vector<std::size_t> elements_at(TokenReader& reader) {
  std::vector<std::size_t> elements;
  reader.expect('[');
  do {
    elements.push_back(reader.position());
    while (!reader.at_symbol(',') && !reader.at_symbol(']'))
      pass_over_brackets(reader);
  } while (reader.accept(','));
  reader.expect(']');
  return elements;
}

/// Parameters are data whose values are not in the text. Reads from after the opening bracket.
void read_parameters(TokenReader& reader, RapidRoutine& routine) {
  RapidData parameter;
  parameter.file = routine.file;
  do {
    parameter.line = reader.place().line;
    if (reader.at_end()) reader.fail("the file ends within parameters", "give all of it");
    if (reader.peek().kind == TokenKind::kName)
      parameter.name = reader.peek().text;
    else
      routine.data.emplace(lower_case(parameter.name), parameter);
    if (reader.at_symbol('{')) {
      pass_over_brackets(reader);
      continue;
    }
    if (reader.accept(')')) break;
    reader.next();
  } while (true);
}

const char* end_of(RapidRoutineKind kind) {
  if (kind == RapidRoutineKind::kFunction) return "ENDFUNC";
  return kind == RapidRoutineKind::kTrap ? "ENDTRAP" : "ENDPROC";
}

}  // namespace

RapidSource::RapidSource(const std::vector<SourceFile>& files) : files_(files) {
  tokens_.reserve(files.size());
  for (std::size_t file = 0; file < files.size(); ++file) {
    tokens_.push_back(rapid_tokens(files[file]));
    read(file);
  }
}

TokenReader RapidSource::reader(std::size_t file, std::size_t position) const {
  TokenReader reader(files_[file], file, tokens_[file]);
  reader.go_to(position);
  return reader;
}

void RapidSource::read(std::size_t file) {
  TokenReader reader = this->reader(file, 0);
  bool found = false;
  while (!reader.at_end()) {
    if (!reader.accept("MODULE")) {
      reader.next();  // the header that controllers write first
      continue;
    }
    found = true;
    read_module(reader, file);
  }
  if (!found) reader.fail("no MODULE in this file", "give a module of RAPID");
}

void RapidSource::read_module(TokenReader& reader, std::size_t file) {
  modules_.emplace_back();
  reader.name();
  if (reader.at_symbol('(')) pass_over_brackets(reader);
  while (!reader.accept("ENDMODULE")) {
    const bool local = reader.accept("LOCAL");
    reader.accept("TASK");
    if (at_declaration(reader)) {
      read_data(reader, file, modules_.back().data, local);
    } else if (reader.accept("PROC")) {
      read_routine(reader, file, RapidRoutineKind::kProcedure, local);
    } else if (reader.accept("FUNC")) {
      reader.name();  // its type
      read_routine(reader, file, RapidRoutineKind::kFunction, local);
    } else if (reader.accept("TRAP")) {
      read_routine(reader, file, RapidRoutineKind::kTrap, local);
    } else if (reader.accept("RECORD")) {
      while (!reader.at_end() && !reader.accept("ENDRECORD"))
        reader.next();
    } else if (reader.accept("ALIAS")) {
      pass_over_statement(reader);
    } else {
      reader.fail(reader.at_end() ? "the file ends within a module"
                                  : scan_cell_common::excerpt(reader.peek().text),
                  "expected a declaration or a routine");
    }
  }
}

void RapidSource::read_data(TokenReader& reader, std::size_t file,
                            std::map<std::string, RapidData>& data, bool local) {
  reader.next();
  RapidData declared;
  declared.file = file;
  declared.type = lower_case(reader.name());
  declared.line = reader.place().line;
  declared.name = reader.name();
  declared.list = reader.at_symbol('{');
  if (declared.list) pass_over_brackets(reader);
  if (reader.accept(':')) {
    reader.expect('=');
    if (declared.list && reader.at_symbol('['))
      declared.values = elements_at(reader);
    else
      declared.values = {reader.position()};
  }
  while (!reader.at_symbol(';'))
    pass_over_brackets(reader);
  const std::string key = lower_case(declared.name);
  if (!data.emplace(key, declared).second ||
      (!local && !global_data_.emplace(key, modules_.size() - 1).second))
    reader.fail(declared.name + " is declared twice", "give each module once");
  reader.expect(';');
}

void RapidSource::read_routine(TokenReader& reader, std::size_t file, RapidRoutineKind kind,
                               bool local) {
  RapidRoutine& routine = routines_.emplace_back();
  routine.kind = kind;
  routine.file = file;
  routine.module = modules_.size() - 1;
  routine.name = reader.name();
  if (reader.accept('(')) read_parameters(reader, routine);
  while (at_declaration(reader))
    read_data(reader, file, routine.data, true);
  routine.body = reader.position();
  while (!reader.at_name(end_of(kind))) {
    if (reader.at_end()) reader.fail("the file ends within " + routine.name, "give all of it");
    reader.next();
  }
  routine.end = reader.position();
  const std::string key = lower_case(routine.name);
  if (!modules_.back().routines.emplace(key, &routine).second ||
      (!local && !global_routines_.emplace(key, routine.module).second))
    reader.fail(routine.name + " appears twice", "give each module once");
  reader.next();
}

const RapidData* RapidSource::data(const std::string& name, const RapidRoutine& seen_from) const {
  const std::string key = lower_case(name);
  if (const auto own = seen_from.data.find(key); own != seen_from.data.end()) return &own->second;
  const auto& near = modules_[seen_from.module].data;
  if (const auto found = near.find(key); found != near.end()) return &found->second;
  const auto global = global_data_.find(key);
  return global == global_data_.end() ? nullptr : &modules_[global->second].data.at(key);
}

const RapidRoutine* RapidSource::routine(const std::string& name,
                                         const RapidRoutine& seen_from) const {
  const std::string key = lower_case(name);
  const auto& near = modules_[seen_from.module].routines;
  if (const auto found = near.find(key); found != near.end()) return found->second;
  const auto global = global_routines_.find(key);
  return global == global_routines_.end() ? nullptr : modules_[global->second].routines.at(key);
}

const RapidRoutine& RapidSource::first_routine() const {
  const std::string file = files_.front().name;
  const std::string stem = lower_case(file.substr(0, file.find_last_of('.')));
  const RapidRoutine* called_like_file = nullptr;
  const RapidRoutine* only = nullptr;
  std::string names;
  std::size_t count = 0;
  for (const RapidRoutine& routine : routines_) {
    if (routine.file != 0 || routine.kind != RapidRoutineKind::kProcedure) continue;
    const std::string name = lower_case(routine.name);
    if (name == "main") return routine;
    if (name == stem) called_like_file = &routine;
    only = &routine;
    names += (names.empty() ? "" : ", ") + routine.name;
    ++count;
  }
  if (called_like_file) return *called_like_file;
  if (count == 1) return *only;
  throw scan_cell_common::UnusableInput(
      file, count == 0 ? "no PROC" : "it does not say where to begin: " + names,
      "give it a routine main, or one with the name of the file");
}

}  // namespace tool_path_programs
