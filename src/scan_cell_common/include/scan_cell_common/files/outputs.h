// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace scan_cell_common {

/// Removes a file that an earlier run left.
/// @throw FileError if it is not a regular file (a folder, a device, a link), or cannot be removed
void remove_old(const std::string& path);

/// The options of a tool that name its outputs. tool_main() removes what an earlier run left there
/// before the tool works, even if the options are bad, so that a result found after a run is always
/// from this run.
class Outputs {
 public:
  /// Who removes what an earlier run left.
  enum class Clearing {
    kBeforeWork,  //!< tool_main(), before the tool works
    kByTool       //!< which reports faulty names in its own way
  };

  Outputs() = default;
  /// @param clearing who removes what an earlier run left
  explicit Outputs(Clearing clearing) : clearing_(clearing) {}

  /// Adds an option for a file.
  /// @param path receives the option's value
  /// @return the option, for required() and the like
  CLI::Option* add(CLI::App& app, const std::string& name, std::string& path,
                   const std::string& description);

  /// Adds an option for a folder, in which the tool writes these files.
  CLI::Option* add_folder(CLI::App& app, const std::string& name, std::string& path,
                          const std::string& description, const std::vector<std::string>& files);

  /// Removes the files of all outputs, unless the tool does that. Removes nothing unless all may be
  /// removed.
  /// @param words of the command line
  /// @throw FileError as refuse_overwriting() of files.h, for any other word, and as remove_old()
  void clear(const std::vector<std::string>& words) const;

  /// The same if the options are bad: leaves alone what is not a regular file or is named by any
  /// other word.
  void clear_where_possible(const std::vector<std::string>& words) const;

 private:
  struct Output {
    const CLI::App* app;
    const CLI::Option* option;
    std::vector<std::string> files;  // in the folder; empty: the output is a file
  };

  /// A file to be written, and the words that name other things.
  struct Named {
    std::string path;
    std::vector<std::string> others;
  };

  std::vector<Named> find(const std::vector<std::string>& words) const;

  Clearing clearing_ = Clearing::kBeforeWork;
  std::vector<Output> outputs_;
};

}  // namespace scan_cell_common
