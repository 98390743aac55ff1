// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "rapid/rapid.h"

#include "rapid/rapid_writer.h"
#include "rapid_reader/rapid_reader.h"

namespace tool_path_programs {
namespace {

class Rapid : public Language {
 public:
  std::string name() const override { return "rapid"; }
  std::string title() const override { return "ABB RAPID (IRC5, OmniCore)"; }
  std::vector<std::string> extensions() const override { return {".mod", ".modx", ".prg"}; }

  WrittenProgram write(const Program& program, const WriteSettings& settings) const override {
    return write_rapid(program, settings);
  }
  Unsaid unsaid(const WriteSettings& /*settings*/) const override { return {}; }
  ProgramText read(const std::vector<SourceFile>& files,
                   const ReadSettings& settings) const override {
    return read_rapid(files, settings);
  }
  std::vector<TextEdit> edits(const ProgramText& text,
                              const std::vector<Eigen::Isometry3d>& poses) const override {
    return rapid_edits(text, poses);
  }
  std::vector<TextEdit> lines(const ProgramText& text,
                              const std::vector<ArcLines>& arcs) const override {
    return rapid_lines(text, arcs);
  }
};

}  // namespace

const Language& rapid() {
  static const Rapid language;
  return language;
}

}  // namespace tool_path_programs
