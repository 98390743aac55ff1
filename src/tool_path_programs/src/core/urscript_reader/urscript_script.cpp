// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "urscript_reader/urscript_script.h"

#include <algorithm>
#include <utility>

#include "scan_cell_common/errors/errors.h"
#include "urscript_reader/urscript_names.h"

namespace tool_path_programs {
namespace {

bool opens_function(const Token& token) {
  return is_script_name(token, "def") || is_script_name(token, "thread") ||
         is_script_name(token, "sec");
}

bool opens_block(const Token& token) {
  return opens_function(token) || is_script_name(token, "while") || is_script_name(token, "if") ||
         is_script_name(token, "switch");
}

bool opens_case(const Token& token) {
  return is_script_name(token, "case") || is_script_name(token, "default");
}

bool is_output(std::string_view name) {
  return name == "set_digital_out" || name == "set_standard_digital_out" ||
         name == "set_configurable_digital_out" || name == "set_tool_digital_out";
}

std::vector<Token> tokens_without_comments(const SourceFile& file) {
  static const LexicalRules rules{{"#"}, "\"", ""};
  std::vector<Token> tokens = tokens_of(file, rules);
  tokens.erase(std::remove_if(tokens.begin(), tokens.end(),
                              [](const Token& token) { return token.kind == TokenKind::kComment; }),
               tokens.end());
  return tokens;
}

}  // namespace

bool is_script_symbol(const Token& token, char symbol) {
  return token.kind == TokenKind::kSymbol && token.text.front() == symbol;
}

bool is_script_name(const Token& token, std::string_view name) {
  return token.kind == TokenKind::kName && token.text == name;
}

Script::Script(const std::vector<SourceFile>& files) : files_(files), ends_(files.size()) {
  for (std::size_t file = 0; file < files.size(); ++file) {
    tokens_.push_back(tokens_without_comments(files[file]));
    find_blocks(file);
  }
  find_out_what_acts();
}

void Script::find_blocks(std::size_t file) {
  const std::vector<Token>& tokens = tokens_[file];
  std::vector<std::size_t> open;
  std::size_t open_functions = 0;
  for (std::size_t at = 0; at < tokens.size(); ++at) {
    const bool is_member = at > 0 && is_script_symbol(tokens[at - 1], '.');
    if (tokens[at].kind != TokenKind::kName || is_member) continue;
    const bool in_switch = !open.empty() && is_script_name(tokens[open.back()], "switch");
    if (opens_block(tokens[at]) || (in_switch && opens_case(tokens[at]))) {
      open.push_back(at);
      open_functions += opens_function(tokens[at]) ? 1 : 0;
    } else if (is_script_name(tokens[at], "end")) {
      if (open.empty()) fail(place(file, at), "an end without a block", "correct the program");
      ends_[file][open.back()] = at;
      if (opens_function(tokens[open.back()]))
        add_function(file, open.back(), at, --open_functions == 0);
      open.pop_back();
    }
  }
  if (!open.empty())
    fail(place(file, open.back()), std::string(tokens[open.back()].text) + " without an end",
         "give the whole program");
}

void Script::add_function(std::size_t file, std::size_t opening, std::size_t end,
                          bool is_outermost) {
  const std::vector<Token>& tokens = tokens_[file];
  ScriptFunction function;
  std::size_t at = opening + 1;
  if (tokens[at].kind != TokenKind::kName)
    fail(place(file, opening), "a function without a name", "correct the program");
  function.name = tokens[at].text;
  function.is_thread = !is_script_name(tokens[opening], "def");
  function.is_outermost = is_outermost;
  for (; at < end && !is_script_symbol(tokens[at], ':'); ++at) {
    const bool is_first = is_script_symbol(tokens[at], '(') || is_script_symbol(tokens[at], ',');
    if (is_first && tokens[at + 1].kind == TokenKind::kName)
      function.parameters.emplace_back(tokens[at + 1].text);
  }
  if (at == end) fail(place(file, opening), "a function without ':'", "correct the program");
  function.body = {file, at + 1, end};
  by_name_.emplace(function.name, functions_.size());
  functions_.push_back(std::move(function));
}

template <class Visit>
void Script::visit(const TokenRange& range, Visit visit) const {
  for (std::size_t at = range.begin; at < range.end; ++at) {
    const Token& token = tokens_[range.file][at];
    if (token.kind != TokenKind::kName) continue;
    const bool is_member = at > 0 && is_script_symbol(tokens_[range.file][at - 1], '.');
    if (!is_member && opens_function(token))
      at = end_of(range.file, at);
    else if (!is_member)
      visit(at);
  }
}

std::vector<std::size_t> Script::calls_in(const TokenRange& range) const {
  std::vector<std::size_t> calls;
  visit(range, [&](std::size_t at) {
    const std::vector<Token>& tokens = tokens_[range.file];
    if (is_script_symbol(tokens[at + 1], '(') && !is_urscript_keyword(tokens[at].text))
      calls.push_back(at);
  });
  return calls;
}

std::set<std::string> Script::assigned_in(const TokenRange& range) const {
  std::set<std::string> names;
  const std::vector<Token>& tokens = tokens_[range.file];
  visit(range, [&](std::size_t at) {
    // a[1] = and a.x = change a; named arguments look alike, which only makes the reader more
    // careful
    constexpr std::size_t kFarthest = 32;
    std::size_t after = at + 1;
    while (after < std::min(range.end, at + kFarthest) && !is_script_symbol(tokens[after], '=') &&
           (is_script_symbol(tokens[after], '[') || is_script_symbol(tokens[after], ']') ||
            is_script_symbol(tokens[after], '.') || tokens[after].kind == TokenKind::kNumber ||
            (after > at + 1 && tokens[after].kind == TokenKind::kName)))
      ++after;
    if (after + 1 < tokens.size() && is_script_symbol(tokens[after], '=') &&
        !is_script_symbol(tokens[after + 1], '='))
      names.emplace(tokens[at].text);
  });
  return names;
}

void Script::find_out_what_acts() {
  std::vector<std::vector<std::size_t>> callers(functions_.size());
  std::vector<std::size_t> moving;
  std::vector<std::size_t> acting;
  for (std::size_t i = 0; i < functions_.size(); ++i) {
    for (const std::size_t call : calls_in(functions_[i].body)) {
      const std::string_view name = tokens_[functions_[i].body.file][call].text;
      const auto [first, last] = by_name_.equal_range(name);
      for (auto called = first; called != last; ++called)
        callers[called->second].push_back(i);
      if (first != last) continue;
      if (is_urscript_function_with_motion(name)) moving.push_back(i);
      if (is_urscript_function_with_motion(name) || is_output(name)) acting.push_back(i);
    }
  }
  const auto spread = [&](std::vector<std::size_t> open, bool ScriptFunction::*flag) {
    while (!open.empty()) {
      const std::size_t i = open.back();
      open.pop_back();
      if (std::exchange(functions_[i].*flag, true)) continue;
      open.insert(open.end(), callers[i].begin(), callers[i].end());
    }
  };
  spread(std::move(moving), &ScriptFunction::moves);
  spread(std::move(acting), &ScriptFunction::acts);
}

const ScriptFunction* Script::function(std::string_view name, const Place& place) const {
  const auto [first, last] = by_name_.equal_range(name);
  if (first == last) return nullptr;
  if (std::next(first) != last)
    fail(place, "there are several functions " + std::string(name), "give one of them alone");
  return &functions_[first->second];
}

std::size_t Script::end_of(std::size_t file, std::size_t opening) const {
  return ends_[file].at(opening);
}

bool Script::moves(const TokenRange& range) const {
  const std::vector<std::size_t> calls = calls_in(range);
  return std::any_of(calls.begin(), calls.end(), [&](std::size_t call) {
    const std::string_view name = tokens_[range.file][call].text;
    const auto [first, last] = by_name_.equal_range(name);
    if (first == last) return is_urscript_function_with_motion(name);
    return std::any_of(first, last, [&](const auto& at) { return functions_[at.second].moves; });
  });
}

Place Script::place(std::size_t file, std::size_t token) const {
  return {file, tokens_[file][token].line};
}

void Script::fail(const Place& place, const std::string& value, const std::string& cure) const {
  throw scan_cell_common::UnusableInput(to_string(place, files_), value, cure);
}

}  // namespace tool_path_programs
