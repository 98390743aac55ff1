// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <map>
#include <sstream>

#include "fanuc_reader/fanuc_angles.h"
#include "fanuc_reader/fanuc_reader.h"
#include "fanuc_reader/fanuc_source.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/errors/text.h"
#include "text/arc_statement.h"
#include "text/number_text.h"

namespace tool_path_programs {
namespace {

constexpr int kMostPositions = 32766;  // position numbers that controllers take

/// Puts lines into programs, and their positions after the existing ones.
class FanucLines {
 public:
  explicit FanucLines(const ProgramText& text) : text_(text), source_(text.files) {}

  void add(const ArcLines& arc) {
    file_ = text_.steps[arc.step].place.file;
    const PoseText& target = text_.poses.at(*text_.steps[arc.step].pose);
    check_groups(arc.step, position_at(target).second);
    ArcStatement end(text_, arc.step);
    const ArcText& pieces = end.pieces();
    end.put(pieces.word, "L").put(pieces.via, "");
    const bool stops = std::get<Move>(text_.program.steps[arc.step]).zone == 0;
    const std::string options =
        options_of_motion(arc.step, {pieces.zone.end, pieces.statement.end});
    std::vector<std::string> statements;
    for (const Eigen::Isometry3d& pose : arc.poses) {
      ArcStatement line = end;
      line.put(pieces.target, "P[" + std::to_string(add_position(target, pose)) + "]");
      // Outputs after the zone belong to the end of the arc.
      line.put({pieces.zone.begin, pieces.statement.end},
               (stops ? "CNT100" : line.piece(pieces.zone)) + options + "    ;");
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

  /// The options after the zone that hold for the whole motion.
  std::string options_of_motion(std::size_t step, const ByteRange& range) const {
    const std::string& file = text_.files[file_].text;
    std::istringstream words(file.substr(range.begin, range.end - range.begin));
    std::string options;
    for (std::string word; words >> word;) {
      const std::string lower = scan_cell_common::lower_case(word);
      if (lower == "coord" || lower == "rtcp") refuse_arc(text_, step, "an arc with " + word);
      if (lower.rfind("acc", 0) == 0 || lower == "wjnt" || lower == "pth") options += " " + word;
    }
    return options;
  }

  /// Refuses other axes: they would move all the way in the first line.
  void check_groups(std::size_t step, const std::string& position) const {
    for (const char* other : {"GP2", "E1=", "E1 ="})
      if (position.find(other) != std::string::npos)
        refuse_arc(text_, step,
                   "an arc along which other axes may move (" + std::string(other) + ")");
  }

  /// A position and its text.
  std::pair<FanucPosition, std::string> position_at(const PoseText& pose) const {
    TokenReader reader = source_.reader(pose.place.file, 0);
    reader.go_to_byte(pose.offset);
    const FanucPosition position = read_fanuc_position(reader);
    return {position, text_.files[pose.place.file].text.substr(pose.offset,
                                                               reader.end_of_last() - pose.offset)};
  }

  /// Copies the position of the arc's end, with another pose.
  /// @return its number
  int add_position(const PoseText& target, const Eigen::Isometry3d& pose) {
    int& last = last_.try_emplace(file_, program().positions.rbegin()->first).first->second;
    if (++last > kMostPositions)
      throw scan_cell_common::UnusableInput(to_string(target.place, text_.files),
                                            "no number is left for another position",
                                            "raise the arc tolerance to keep the arc");
    const auto [old, text] = position_at(target);
    std::vector<TextEdit> edits;
    const std::size_t bracket = text.find('[') + 1;
    edits.push_back({0, bracket, text.find(']') - bracket, std::to_string(last)});
    const FanucPose numbers = fanuc_pose(pose, {kFanucDigits, kFanucDigits, kFanucDigits});
    for (std::size_t i = 0; i < numbers.size(); ++i)
      edits.push_back({0, old.pose[i]->offset - old.offset, old.pose[i]->length,
                       fixed(numbers[i], kFanucDigits)});
    const bool dos = text_.files[file_].text.find("\r\n") != std::string::npos;
    positions_[file_] += edited({{"", text}}, edits).front().text + (dos ? "\r\n" : "\n");
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
  std::map<std::size_t, int> last_;               // last position number, of each file
  std::map<std::size_t, std::string> positions_;  // new positions, of each file
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
