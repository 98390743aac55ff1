// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "gcode/gcode.h"

#include "gcode/gcode_writer.h"
#include "gcode_reader/gcode_axes.h"
#include "gcode_reader/gcode_reader.h"

namespace tool_path_programs {
namespace {

class Gcode : public Language {
 public:
  std::string name() const override { return "gcode"; }
  std::string title() const override { return "G-code"; }
  std::vector<std::string> extensions() const override { return {".ngc", ".nc", ".gcode", ".tap"}; }

  WrittenProgram write(const Program& program, const WriteSettings& settings) const override {
    return write_gcode(program, settings);
  }

  Unsaid unsaid(const WriteSettings& settings) const override {
    return {false, !GcodeDialect(settings.dialect).says_orientations()};
  }

  ProgramText read(const std::vector<SourceFile>& files,
                   const ReadSettings& settings) const override {
    return read_gcode(files, settings);
  }

  std::vector<TextEdit> edits(const ProgramText& text,
                              const std::vector<Eigen::Isometry3d>& poses) const override {
    return edits_of_gcode(text, poses);
  }
  std::vector<TextEdit> lines(const ProgramText& text,
                              const std::vector<ArcLines>& arcs) const override {
    return lines_of_gcode(text, arcs);
  }
  bool moves_arcs() const override { return false; }
};

}  // namespace

const Language& gcode() {
  static const Gcode language;
  return language;
}

}  // namespace tool_path_programs
