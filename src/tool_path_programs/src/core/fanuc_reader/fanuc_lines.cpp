// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cctype>
#include <map>

#include "fanuc_reader/fanuc_angles.h"
#include "fanuc_reader/fanuc_reader.h"
#include "fanuc_reader/fanuc_source.h"
#include "scan_cell_common/errors/errors.h"
#include "text/arc_statement.h"
#include "text/number_text.h"

namespace tool_path_programs {
namespace {

constexpr int kMostPositions = 32766;  // numbers of positions that controllers take

/// Puts lines into programs, and their positions behind those that are there.
class FanucLines {
 public:
  explicit FanucLines(const ProgramText& text) : text_(text), source_(text.files) {}

  void add(const ArcLines& arc) {
    file_ = text_.steps[arc.step].place.file;
    const PoseText& target = text_.poses.at(*text_.steps[arc.step].pose);
    ArcStatement end(text_, arc.step);
    const ArcText& pieces = end.pieces();
    end.put(pieces.word, "L").put(pieces.via, "");
    const bool stops = std::toupper(end.piece(pieces.zone).front()) != 'C';
    std::vector<std::string> statements;
    for (const Eigen::Isometry3d& pose : arc.poses) {
      ArcStatement line = end;
      line.put(pieces.target, "P[" + std::to_string(add_position(target, pose)) + "]");
      // Options behind it, such as outputs, are of the end.
      line.put({pieces.zone.begin, pieces.statement.end},
               (stops ? "CNT100" : line.piece(pieces.zone)) + "    ;");
      statements.push_back(line.text());
    }
    statements.push_back(end.text());
    edits_.push_back(in_place_of_arc(text_, arc.step, statements, "    :"));
  }

  std::vector<TextEdit> edits() {
    for (const auto& [file, positions] : positions_)
      edits_.push_back({file, end_of_positions(file), 0, positions});
    return std::move(edits_);
  }

 private:
  const FanucProgram& program() const {
    const auto& all = source_.programs();
    return *std::find_if(all.begin(), all.end(),
                         [&](const FanucProgram& one) { return one.file == file_; });
  }

  /// As the position where the arc leads to, with other numbers.
  /// @return its number
  int add_position(const PoseText& target, const Eigen::Isometry3d& pose) {
    int& last = last_.try_emplace(file_, program().positions.rbegin()->first).first->second;
    if (++last > kMostPositions)
      throw scan_cell_common::UnusableInput(to_string(target.place, text_.files),
                                            "no number is left for another position",
                                            "allow the arc by a tolerance");
    const std::string& file = text_.files[file_].text;
    const auto tokens = fanuc_tokens(text_.files[file_]);
    TokenReader reader(text_.files[file_], file_, tokens);
    reader.go_to(static_cast<std::size_t>(
        std::lower_bound(tokens.begin(), tokens.end(), target.offset,
                         [](const Token& token, std::size_t byte) { return token.offset < byte; }) -
        tokens.begin()));
    const FanucPosition old = read_fanuc_position(reader);
    const std::size_t end = reader.end_of_last();
    std::vector<TextEdit> edits;
    const std::size_t bracket = file.find('[', old.offset);
    const std::size_t closing = file.find(']', bracket);
    edits.push_back({0, bracket + 1 - old.offset, closing - bracket - 1, std::to_string(last)});
    const FanucPose numbers = fanuc_pose(pose, {kFanucDigits, kFanucDigits, kFanucDigits});
    for (std::size_t i = 0; i < numbers.size(); ++i)
      edits.push_back({0, old.pose[i]->offset - old.offset, old.pose[i]->length,
                       fixed(numbers[i], kFanucDigits)});
    positions_[file_] +=
        edited({{"", file.substr(old.offset, end - old.offset)}}, edits).front().text +
        (file.find("\r\n") == std::string::npos ? "\n" : "\r\n");
    return last;
  }

  /// Where the line with /END begins.
  std::size_t end_of_positions(std::size_t file) const {
    const std::string& text = text_.files[file].text;
    for (std::size_t at = text.size(); (at = text.rfind('/', at)) != std::string::npos && at > 0;
         --at)
      if (text.compare(at, 4, "/END") == 0 || text.compare(at, 4, "/end") == 0) return at;
    return text.size();
  }

  const ProgramText& text_;
  const FanucSource source_;
  std::size_t file_ = 0;
  std::map<std::size_t, int> last_;               // number of a position, of each file
  std::map<std::size_t, std::string> positions_;  // that are new, of each file
  std::vector<TextEdit> edits_;
};

}  // namespace

std::vector<TextEdit> fanuc_lines(const ProgramText& text, const std::vector<ArcLines>& arcs) {
  FanucLines lines(text);
  for (const ArcLines& arc : arcs)
    lines.add(arc);
  return lines.edits();
}

}  // namespace tool_path_programs
