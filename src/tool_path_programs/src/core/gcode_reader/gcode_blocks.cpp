// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "gcode_reader/gcode_blocks.h"

#include <algorithm>
#include <charconv>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/errors/text.h"

namespace tool_path_programs {
namespace {

bool is_digit(char character) {
  return character >= '0' && character <= '9';
}

class Lines {
 public:
  explicit Lines(const SourceFile& file) : file_(file), text_(file.text) {}

  std::vector<GcodeBlock> run() {
    std::vector<GcodeBlock> blocks;
    for (std::size_t line = 1; at_ < text_.size(); ++line) {
      end_ = std::min(text_.find('\n', at_), text_.size());
      block_ = GcodeBlock();
      block_.line = line;
      read_line();
      if (!block_.words.empty()) blocks.push_back(std::move(block_));
      at_ = std::min(end_ + 1, text_.size());
    }
    return blocks;
  }

 private:
  void read_line() {
    pass_blanks();
    if (at_ == end_ || text_[at_] == '%' || text_[at_] == '#') return;
    if (text_[at_] == '/') {
      block_.may_be_skipped = true;
      ++at_;
    }
    for (pass_blanks(); at_ < end_; pass_blanks())
      add_word();
  }

  /// Skips blanks and comments.
  void pass_blanks() {
    while (at_ < end_) {
      const char character = text_[at_];
      if (character == ';')
        at_ = end_;
      else if (character == '(')
        pass_bracket();
      else if (character == ' ' || character == '\t' || character == '\r')
        ++at_;
      else
        return;
    }
  }

  void pass_bracket() {
    const std::size_t close = text_.find(')', at_);
    if (close >= end_) fail("a bracket that is not closed on its line", "close it");
    at_ = close + 1;
  }

  void add_word() {
    GcodeWord word;
    word.offset = at_;
    word.letter = upper(text_[at_]);
    if (word.letter < 'A' || word.letter > 'Z')
      fail(scan_cell_common::excerpt(text_.substr(at_, end_ - at_)), "expected a word");
    ++at_;
    while (at_ < end_ && (text_[at_] == ' ' || text_[at_] == '\t'))
      ++at_;
    read_number(word);
    if (word.letter == 'N') return;
    if (word.letter == 'O') return check_program_number();
    block_.words.push_back(word);
  }

  void read_number(GcodeWord& word) {
    word.number_offset = at_;
    std::size_t begin = at_;
    if (begin < end_ && (text_[begin] == '+' || text_[begin] == '-')) ++begin;
    std::size_t end = begin;
    while (end < end_ && (is_digit(text_[end]) || text_[end] == '.'))
      ++end;
    const auto read = std::from_chars(text_.data() + begin, text_.data() + end, word.value,
                                      std::chars_format::fixed);
    if (begin == end || read.ec != std::errc() || read.ptr != text_.data() + end)
      fail(scan_cell_common::excerpt(text_.substr(word.offset, end_ - word.offset)),
           "give each letter a number: values that are computed are not known here");
    if (text_[word.number_offset] == '-') word.value = -word.value;
    word.number_length = end - word.number_offset;
    at_ = end;
  }

  /// O1000 alone on a line, as controllers name programs.
  void check_program_number() {
    pass_blanks();
    if (at_ < end_ || !block_.words.empty())
      fail("a subroutine or a condition (O word)", "give the program written out");
  }

  static char upper(char letter) {
    return letter >= 'a' && letter <= 'z' ? static_cast<char>(letter - 'a' + 'A') : letter;
  }

  [[noreturn]] void fail(const std::string& value, const std::string& cure) const {
    throw scan_cell_common::UnusableInput(file_.name + ", line " + std::to_string(block_.line),
                                          value, cure);
  }

  const SourceFile& file_;
  const std::string_view text_;
  std::size_t at_ = 0;
  std::size_t end_ = 0;  // of the line
  GcodeBlock block_;
};

}  // namespace

const GcodeWord* GcodeBlock::find(char letter) const {
  const auto found = std::find_if(words.rbegin(), words.rend(),
                                  [&](const GcodeWord& word) { return word.letter == letter; });
  return found == words.rend() ? nullptr : &*found;
}

ByteRange gcode_range(const GcodeBlock& block) {
  const GcodeWord& last = block.words.back();
  return {block.words.front().offset, last.number_offset + last.number_length};
}

std::vector<GcodeBlock> gcode_blocks(const SourceFile& file) {
  return Lines(file).run();
}

}  // namespace tool_path_programs
