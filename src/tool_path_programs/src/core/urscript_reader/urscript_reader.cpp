// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "urscript_reader/urscript_reader.h"

#include <filesystem>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/errors/text.h"
#include "urscript_reader/urscript_expressions.h"
#include "urscript_reader/urscript_names.h"
#include "urscript_reader/urscript_recorder.h"
#include "urscript_reader/urscript_script.h"

namespace tool_path_programs {
namespace {

constexpr std::size_t kDeepest = 100;  // calls and loops within each other
// Limit of tokens read, calls followed: at least this, and more in proportion to the text.
constexpr std::size_t kMostTokens = 10'000'000;
constexpr std::size_t kMostTokensEach = 50;

/// How a range of statements ends.
enum class Flow { kGoesOn, kReturns, kEndsProgram };

/// Follows a script in the order of its motion.
class Run {
 public:
  Run(const std::vector<SourceFile>& files, const ReadSettings& settings)
      : script_(files), settings_(settings), files_(files), recorder_(files, settings) {
    readers_.reserve(files.size());
    for (std::size_t file = 0; file < files.size(); ++file)
      add_reader(file);
    for (const ScriptFunction& function : script_.functions())
      if (function.is_thread)
        for (const std::string& name : script_.assigned_in(function.body))
          variables_.forget_for_ever(name);
  }

  ProgramText run() {
    const TokenRange whole = script_.whole(0);
    const ScriptFunction* main = main_function(whole);
    if (main != nullptr) name_ = main->name;
    if (run(whole) != Flow::kEndsProgram && main != nullptr && !main_is_called_) run_main(*main);
    return recorder_.done(name_);
  }

 private:
  void add_reader(std::size_t file) {
    readers_.emplace_back(files_[file], file, script_.tokens()[file]);
    most_ += kMostTokensEach * script_.tokens()[file].size();
  }

  TokenReader& reader() { return readers_[file_]; }

  /// The function that is the program: the one called, or the only one.
  const ScriptFunction* main_function(const TokenRange& whole) {
    name_ = std::filesystem::path(files_[0].name).stem().string();
    for (const std::size_t call : script_.calls_in(whole)) {
      const ScriptFunction* called = function_at(call);
      if (called == nullptr || called->is_thread) continue;
      main_is_called_ = true;
      return called;
    }
    if (script_.moves(whole)) return nullptr;
    const ScriptFunction* only = nullptr;
    for (const ScriptFunction& function : script_.functions()) {
      if (!function.is_outermost || function.is_thread || function.body.file != 0) continue;
      if (function.name == name_) return &function;
      if (only != nullptr)
        script_.fail(script_.place(0, whole.end), "several functions, and none is called",
                     "give the program that calls them, or name the file as one of them");
      only = &function;
    }
    return only;
  }

  const ScriptFunction* function_at(std::size_t token) const {
    return script_.function(script_.tokens()[file_][token].text, script_.place(file_, token));
  }

  void run_main(const ScriptFunction& main) {
    running_.insert(&main);
    run(main.body);
  }

  Flow run(const TokenRange& range) {
    if (++depth_ > kDeepest)
      script_.fail(script_.place(range.file, range.begin), "calls or loops nested too deeply",
                   "give a program with fewer levels");
    file_ = range.file;
    reader().go_to(range.begin);
    Flow flow = Flow::kGoesOn;
    while (flow == Flow::kGoesOn && reader().position() < range.end)
      flow = statement(range);
    --depth_;
    return flow;
  }

  Flow statement(const TokenRange& range) {
    spend(1);
    const std::string word(reader().peek().text);
    const std::size_t begin = reader().position();
    if (reader().at_line_end() || reader().at_symbol(';')) {
      reader().next();
    } else if (reader().at_symbol('$')) {
      reader().skip_line();  // labels of the pendant's program tree
    } else if (reader().peek().kind != TokenKind::kName) {
      reader().fail(scan_cell_common::excerpt(word), "expected a statement");
    } else if (word == "def" || word == "thread" || word == "sec") {
      reader().go_to(script_.end_of(file_, begin) + 1);
    } else if (word == "while" || word == "if" || word == "switch") {
      return block(begin);
    } else if (word == "return" || word == "halt") {
      pass_statement();
      return word == "halt" ? Flow::kEndsProgram : Flow::kReturns;
    } else if (word == "break" || word == "continue") {
      reader().fail(word + " in a loop with motions", "give a program without it");
    } else if (word == "global" || word == "local") {
      reader().next();
      assignment(word);
    } else if (reader().peek_after().text == "(" && !is_urscript_keyword(word)) {
      return call(range);
    } else if (reader().peek_after().text == "=") {
      assignment("");
    } else {
      pass_statement();
    }
    return Flow::kGoesOn;
  }

  /// Follows an endless loop once and skips other blocks.
  Flow block(std::size_t begin) {
    const TokenRange range{file_, begin, script_.end_of(file_, begin)};
    if (!script_.moves(range)) {
      pass_over(range);
      forbid_return(range);
      reader().go_to(range.end + 1);
      return Flow::kGoesOn;
    }
    if (!begins_endless_loop())
      reader().fail("a motion or a tool frame within " + std::string(reader().peek().text),
                    "whether it moves is known at run time: give the program without it");
    const Flow flow = run({file_, reader().position(), range.end});
    return flow == Flow::kGoesOn ? Flow::kEndsProgram : flow;
  }

  /// while True: or while (True):
  bool begins_endless_loop() {
    const std::size_t begin = reader().position();
    const bool is_while = is_script_name(reader().next(), "while");
    const bool bracket = reader().accept('(');
    const bool endless = is_while && is_script_name(reader().next(), "True") &&
                         (!bracket || reader().accept(')')) && reader().accept(':');
    if (!endless) reader().go_to(begin);
    return endless;
  }

  void assignment(const std::string& scope) {
    const std::size_t begin = reader().position();
    if (reader().peek_after().text != "=") return pass_statement();
    const std::string name = reader().name();
    reader().expect('=');
    const std::size_t expression = reader().position();
    const ScriptValue value = ScriptExpressions(reader(), variables_).value();
    check_no_motion({file_, expression, reader().position()});
    forget_what_changes({file_, begin, reader().position()});
    if (scope == "global")
      variables_.assign_globally(name, value);
    else if (scope == "local")
      variables_.assign_locally(name, value);
    else
      variables_.assign(name, value);
  }

  /// Skips a statement that a path does not need, but that may change variables.
  void pass_statement() {
    const std::size_t begin = reader().position();
    std::size_t open = 0;
    while (!reader().at_end() && (open > 0 || !reader().at_line_end())) {
      if (reader().at_symbol('(') || reader().at_symbol('[')) ++open;
      if (open > 0 && (reader().at_symbol(')') || reader().at_symbol(']'))) --open;
      reader().next();
    }
    const TokenRange range{file_, begin, reader().position()};
    check_no_motion(range);
    pass_over(range);
  }

  /// Skips a range without motions.
  void pass_over(const TokenRange& range) {
    check_calls(range);
    forget_what_changes(range);
  }

  void check_no_motion(const TokenRange& range) {
    if (script_.moves(range))
      script_.fail(script_.place(range.file, range.begin), "a motion within another statement",
                   "give it its own line");
    check_calls(range);
  }

  /// Checks that every called function is in the files or known not to move.
  void check_calls(const TokenRange& range) {
    spend(range.end - range.begin);
    for (const std::size_t call : script_.calls_in(range))
      check_known(script_.tokens()[range.file][call].text, script_.place(range.file, call));
  }

  void check_known(std::string_view name, const Place& place) const {
    if (script_.function(name, place) != nullptr || is_urscript_function_without_motion(name) ||
        name == "p" || settings_.calls_without_motion.count(std::string(name)) != 0)
      return;
    script_.fail(place, "calls " + std::string(name) + ", which is not in the files",
                 "give the file that has it, or name it as a call without motion");
  }

  /// Variables set in a range, or in functions that it calls, count as computed from now on.
  void forget_what_changes(const TokenRange& range) {
    std::vector<TokenRange> open = {range};
    std::set<const ScriptFunction*> known;
    while (!open.empty()) {
      const TokenRange part = open.back();
      open.pop_back();
      spend(part.end - part.begin);
      for (const std::string& name : script_.assigned_in(part))
        variables_.forget(name);
      for (const std::size_t call : script_.calls_in(part)) {
        const ScriptFunction* called = script_.function(script_.tokens()[part.file][call].text,
                                                        script_.place(part.file, call));
        if (called != nullptr && known.insert(called).second) open.push_back(called->body);
      }
    }
  }

  /// Forbids statements that may leave a function with motions early.
  void forbid_return(const TokenRange& range) {
    const std::vector<Token>& tokens = script_.tokens()[range.file];
    const bool is_loop = is_script_name(tokens[range.begin], "while");
    for (std::size_t at = range.begin; at < range.end; ++at) {
      const bool leaves = is_script_name(tokens[at], "return") ||
                          (!is_loop && (is_script_name(tokens[at], "break") ||
                                        is_script_name(tokens[at], "continue")));
      if (leaves)
        script_.fail(
            script_.place(range.file, at),
            std::string(tokens[at].text) + " within " + std::string(tokens[range.begin].text),
            "which motions come after it is known at run time: give the program without "
            "it");
    }
  }

  Flow call(const TokenRange& range) {
    const Place place = reader().place();
    const std::size_t begin = reader().position();
    const std::size_t offset = reader().offset();
    const std::string name = reader().name();
    const ScriptArguments arguments = ScriptExpressions(reader(), variables_).arguments();
    const std::size_t end = reader().position();
    const ByteRange text{offset, reader().end_of_last()};
    spend(end - begin);
    const ScriptFunction* function = script_.function(name, place);
    check_no_motion({file_, begin + 1, end});
    if (function != nullptr && function->acts) return follow(*function, arguments, place, range);
    if (function == nullptr && recorder_.record(name, arguments, place, text)) return Flow::kGoesOn;
    check_known(name, place);
    forget_what_changes({file_, begin, end});
    return Flow::kGoesOn;
  }

  Flow follow(const ScriptFunction& function, const ScriptArguments& arguments, const Place& place,
              const TokenRange& caller) {
    if (!running_.insert(&function).second)
      script_.fail(place, function.name + " calls itself", "give a program without recursion");
    const std::size_t back = reader().position();
    const bool is_main = depth_ == 1 && function.parameters.empty();
    ScriptVariables::Locals locals;
    for (std::size_t i = 0; i < function.parameters.size(); ++i) {
      const ScriptValue* value = arguments.find(function.parameters[i], i);
      locals[function.parameters[i]] = value == nullptr ? ScriptValue() : *value;
    }
    std::optional<ScriptVariables::Locals> of_caller;
    if (!is_main) of_caller = variables_.begin_function(std::move(locals));
    const Flow flow = run(function.body);
    if (!is_main) variables_.end_function(std::move(of_caller));
    running_.erase(&function);
    file_ = caller.file;
    reader().go_to(back);
    return flow == Flow::kEndsProgram ? flow : Flow::kGoesOn;
  }

  void spend(std::size_t tokens) {
    spent_ += tokens;
    if (spent_ > most_)
      reader().fail("a program whose calls never seem to end", "give a shorter one");
  }

  const Script script_;
  const ReadSettings& settings_;
  const std::vector<SourceFile>& files_;
  ScriptRecorder recorder_;
  ScriptVariables variables_;
  std::vector<TokenReader> readers_;  // of each file
  std::size_t file_ = 0;
  std::size_t depth_ = 0;
  std::size_t spent_ = 0;           // tokens read
  std::size_t most_ = kMostTokens;  // limit of tokens
  std::set<const ScriptFunction*> running_;
  std::string name_;
  bool main_is_called_ = false;
};

}  // namespace

ProgramText read_urscript(const std::vector<SourceFile>& files, const ReadSettings& settings) {
  if (files.empty())
    throw scan_cell_common::UnusableInput("URScript program", "no file", "give the main file");
  return Run(files, settings).run();
}

}  // namespace tool_path_programs
