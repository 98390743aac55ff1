// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/tools/tool_main.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/errors/text.h"
#include "scan_cell_common/tools/version.h"
#include "tools/suggestion.h"

namespace scan_cell_common {
namespace {

bool is_option(const std::string& word) {
  return word.size() > 1 && word[0] == '-' && !parse_number(word);
}

/// Options of the tool and of the given command.
std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  const auto add = [&names](const CLI::App& from) {
    for (const CLI::Option* option : from.get_options()) {
      if (option->get_group().empty()) continue;  // hidden: a former name
      for (const std::string& name : option->get_lnames())
        names.push_back("--" + name);
    }
  };
  add(app);
  for (const CLI::App* command : app.get_subcommands())
    add(*command);
  return names;
}

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  return names;
}

std::string tell(const std::string& word, const std::string& fault,
                 const std::vector<std::string>& names) {
  const std::string typed = word.substr(0, word.find('='));
  const std::string nearest = nearest_name(typed, names);
  return excerpt(typed) + ": " + fault + "; " +
         (nearest.empty() ? "see --help" : "did you mean " + nearest + "?");
}

/// Reports words that the tool does not know, since they are the cause of whatever else is missing.
/// @return empty if it knows them all
std::string unknown_words(const CLI::App& app) {
  const std::vector<std::string> left = app.remaining(true);
  if (left.empty()) return "";
  const std::vector<std::string> commands =
      app.get_subcommands().empty() ? command_names(app) : std::vector<std::string>();
  if (!commands.empty() && !is_option(left.front()))
    return tell(left.front(), "unknown command", commands);
  const auto option = std::find_if(left.begin(), left.end(), is_option);
  if (option != left.end()) return tell(*option, "unknown option", option_names(app));
  return tell(left.front(), "not expected here", {});
}

int tell_bad_options(const std::string& name, CLI::App& app, const CLI::ParseError& error) {
  const std::string unknown = unknown_words(app);
  std::fprintf(
      stderr, "%s: %s\n", name.c_str(),
      unknown.empty() ? (std::string(error.what()) + "; see --help").c_str() : unknown.c_str());
  return kUnusable;
}

}  // namespace

int tool_main(const std::string& name, CLI::App& options, int argc, char** argv,
              const std::function<int()>& body, int refused, const Outputs& outputs) {
  const auto fail = [&name](const std::exception& error, int code) {
    std::fflush(stdout);
    std::fprintf(stderr, "%s: %s\n", name.c_str(), error.what());
    return code;
  };
  const std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  options.set_version_flag("--version", name + " " + suite_version(), "Print the suite's version");
  try {
    options.parse(argc, argv);
  } catch (const CLI::Success& asked) {
    return options.exit(asked);
  } catch (const CLI::ParseError& error) {
    outputs.clear_where_possible(words);
    return tell_bad_options(name, options, error);
  } catch (const std::exception& error) {  // from what an option does as soon as it is read
    outputs.clear_where_possible(words);
    return fail(error, kUnusable);
  }
  try {
    outputs.clear(words);
    return body();
  } catch (const Refused& error) {
    return fail(error, refused);
  } catch (const std::exception& error) {
    return fail(error, kUnusable);
  }
}

}  // namespace scan_cell_common
