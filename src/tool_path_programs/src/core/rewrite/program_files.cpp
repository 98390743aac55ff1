// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tool_path_programs/program_files.h"

#include <filesystem>

#include "scan_cell_common/files/files.h"

namespace tool_path_programs {
namespace {

namespace fs = std::filesystem;

/// part.dat beside part.src, with the extension in either case.
std::string companion(const fs::path& main, const std::string& extension) {
  for (const fs::directory_entry& entry :
       fs::directory_iterator(main.has_parent_path() ? main.parent_path() : fs::path(".")))
    if (entry.path().stem() == main.stem() && entry.path() != main &&
        scan_cell_common::extension_of(entry.path().string()) == extension)
      return entry.path().string();
  return "";
}

}  // namespace

std::vector<SourceFile> load_program(const Language& language, const std::string& main,
                                     const std::vector<std::string>& others) {
  std::vector<std::string> paths = {main};
  const std::string text = scan_cell_common::read_file(main);
  for (const std::string& extension : language.extensions()) {
    if (extension == scan_cell_common::extension_of(main)) continue;
    const std::string found = companion(main, extension);
    if (!found.empty()) paths.push_back(found);
  }
  paths.insert(paths.end(), others.begin(), others.end());
  std::vector<SourceFile> files = {{fs::path(main).filename().string(), text}};
  for (std::size_t i = 1; i < paths.size(); ++i)
    files.push_back(
        {fs::path(paths[i]).filename().string(), scan_cell_common::read_file(paths[i])});
  return files;
}

std::vector<std::string> names_of_saved(const std::string& output,
                                        const std::vector<SourceFile>& files) {
  std::vector<std::string> names = {output};
  for (std::size_t i = 1; i < files.size(); ++i)
    names.push_back((fs::path(output).parent_path() / files[i].name).string());
  return names;
}

void save_program(const std::string& output, const std::vector<SourceFile>& files) {
  const std::vector<std::string> names = names_of_saved(output, files);
  for (std::size_t i = files.size(); i-- > 0;)
    scan_cell_common::save_text(names[i], files[i].text);
}

}  // namespace tool_path_programs
