// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "text/arc_statement.h"

#include <algorithm>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/errors/text.h"

namespace tool_path_programs {
namespace {

const std::string& file_of(const ProgramText& text, std::size_t step) {
  return text.files.at(text.steps.at(step).place.file).text;
}

/// The line end that the file uses.
std::string line_end(const std::string& file) {
  const std::size_t first = file.find('\n');
  return first != std::string::npos && first > 0 && file[first - 1] == '\r' ? "\r\n" : "\n";
}

/// The blanks before a statement; empty if anything else is before it on its line.
std::string indentation(const std::string& file, std::size_t statement) {
  const std::size_t end = statement == 0 ? std::string::npos : file.rfind('\n', statement - 1);
  const std::size_t begin = end == std::string::npos ? 0 : end + 1;
  std::string blanks = file.substr(begin, statement - begin);
  return blanks.find_first_not_of(" \t") == std::string::npos ? blanks : "";
}

}  // namespace

ArcStatement::ArcStatement(const ProgramText& text, std::size_t step)
    : file_(file_of(text, step)), arc_(text.steps.at(step).arc.value()) {}

std::string ArcStatement::piece(const ByteRange& range) const {
  return file_.substr(range.begin, range.end - range.begin);
}

ArcStatement& ArcStatement::put(const ByteRange& range, const std::string& text) {
  edits_.push_back({0, range.begin - arc_.statement.begin, range.end - range.begin, text});
  return *this;
}

std::string ArcStatement::text() const {
  return edited({{"", piece(arc_.statement)}}, edits_).front().text;
}

TextEdit in_place_of_arc(const ProgramText& text, std::size_t step,
                         const std::vector<std::string>& statements,
                         const std::optional<std::string>& line_begin) {
  const std::string& file = file_of(text, step);
  const ByteRange& old = text.steps.at(step).arc.value().statement;
  const std::string between = line_end(file) + line_begin.value_or(indentation(file, old.begin));
  TextEdit edit{text.steps.at(step).place.file, old.begin, old.end - old.begin, ""};
  for (const std::string& statement : statements)
    edit.text += (edit.text.empty() ? "" : between) + statement;
  return edit;
}

std::optional<std::size_t> move_before(const ProgramText& text, std::size_t step) {
  while (step-- > 0)
    if (text.steps[step].pose) return step;
  return std::nullopt;
}

void refuse_arc(const ProgramText& text, std::size_t step, const std::string& value,
                const std::string& cure) {
  throw scan_cell_common::UnusableInput(to_string(text.steps[step].place, text.files), value, cure);
}

bool mentions(const std::vector<SourceFile>& files, std::initializer_list<const char*> words) {
  return std::any_of(files.begin(), files.end(), [&](const SourceFile& file) {
    const std::string text = scan_cell_common::lower_case(file.text);
    return std::any_of(words.begin(), words.end(),
                       [&](const char* word) { return text.find(word) != std::string::npos; });
  });
}

}  // namespace tool_path_programs
