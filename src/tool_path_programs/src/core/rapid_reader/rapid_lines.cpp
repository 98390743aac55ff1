// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "rapid_reader/rapid_instructions.h"
#include "rapid_reader/rapid_places.h"
#include "rapid_reader/rapid_reader.h"
#include "rapid_reader/source/rapid_statement.h"
#include "text/arc_statement.h"
#include "text/number_text.h"

namespace tool_path_programs {
namespace {

class RapidLines {
 public:
  explicit RapidLines(const ProgramText& text) : text_(text), places_(text.files) {}

  TextEdit edit(const ArcLines& arc) const {
    ArcStatement end(text_, arc.step);
    const ArcText& pieces = end.pieces();
    const std::string name = end.piece(pieces.word);
    const PoseText& target = text_.poses.at(*text_.steps[arc.step].pose);
    check_external_axes(arc.step);
    std::vector<std::string> statements;
    end.put(pieces.via, "");
    for (const Eigen::Isometry3d& pose : arc.poses) {
      ArcStatement line = end;
      const std::size_t behind = rapid_motion(name)->behind;
      line.put(pieces.word, behind > 0 ? "MoveL" : rapid_line_in_place_of(name));
      line.put(pieces.target, literal(target, pose));
      if (std::get<Move>(text_.program.steps[arc.step]).zone == 0) line.put(pieces.zone, "z0");
      leave_out(behind, arc.step, line);
      statements.push_back(line.text());
    }
    end.put(pieces.word, rapid_line_in_place_of(name));
    statements.push_back(end.text());
    return in_place_of_arc(text_, arc.step, statements);
  }

 private:
  /// Refuses external axes: they would move all the way in the first line.
  void check_external_axes(std::size_t step) const {
    const std::size_t before = move_before(text_, step).value();
    const auto to = external_axes(text_.poses.at(*text_.steps[step].pose));
    if (to == external_axes(text_.poses.at(*text_.steps[before].pose))) return;
    refuse_arc(text_, step, "an arc along which external axes move");
  }

  /// The last bracket of a robtarget.
  std::vector<double> external_axes(const PoseText& target) const {
    TokenReader reader = places_.reader(target.place.file, target.offset);
    read_rapid_pose(reader);
    reader.expect(',');
    pass_over_brackets(reader);
    reader.expect(',');
    std::vector<double> axes;
    do {
      reader.next();  // the bracket, or a comma
      axes.push_back(reader.number().value);
    } while (reader.at_symbol(','));
    return axes;
  }

  /// The robtarget of the arc's end, with another pose.
  std::string literal(const PoseText& target, const Eigen::Isometry3d& pose) const {
    TokenReader reader = places_.reader(target.place.file, target.offset);
    const RapidPose old = read_rapid_pose(reader);
    TokenReader whole = places_.reader(target.place.file, target.offset);
    pass_over_brackets(whole);
    const std::array<double, 7> numbers = rapid_numbers(pose, old);
    std::vector<TextEdit> edits;
    for (std::size_t i = 0; i < numbers.size(); ++i)
      edits.push_back({0, old.numbers[i].offset - target.offset, old.numbers[i].length,
                       fixed(numbers[i], i < 3 ? kRapidLengthDigits : kRapidQuaternionDigits + 1)});
    const std::string& file = text_.files[target.place.file].text;
    return edited({{"", file.substr(target.offset, whole.end_of_last() - target.offset)}}, edits)
        .front()
        .text;
  }

  /// Removes the last arguments: what happens at the end of the arc, and not before.
  void leave_out(std::size_t count, std::size_t step, ArcStatement& line) const {
    TokenReader reader =
        places_.reader(text_.steps[step].place.file, line.pieces().statement.begin);
    const RapidCall call = read_rapid_call(reader);
    for (std::size_t i = call.arguments.size() - count; i < call.arguments.size(); ++i) {
      reader.go_to(call.arguments[i].begin - 1);  // its comma
      const std::size_t begin = reader.offset();
      while (reader.position() < call.arguments[i].end)
        reader.next();
      line.put({begin, reader.end_of_last()}, "");
    }
  }

  const ProgramText& text_;
  const RapidPlaces places_;
};

}  // namespace

std::vector<TextEdit> rapid_lines(const ProgramText& text, const std::vector<ArcLines>& arcs) {
  const RapidLines lines(text);
  std::vector<TextEdit> edits;
  for (const ArcLines& arc : arcs)
    edits.push_back(lines.edit(arc));
  return edits;
}

}  // namespace tool_path_programs
