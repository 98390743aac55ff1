// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "urscript/urscript.h"

#include "urscript/urscript_writer.h"
#include "urscript_reader/urscript_reader.h"

namespace tool_path_programs {
namespace {

class Urscript : public Language {
 public:
  std::string name() const override { return "urscript"; }
  std::string title() const override { return "Universal Robots URScript"; }
  std::vector<std::string> extensions() const override { return {".script"}; }

  WrittenProgram write(const Program& program, const WriteSettings& settings) const override {
    return write_urscript(program, settings);
  }

  Unsaid unsaid(const WriteSettings& /*settings*/) const override { return {}; }

  ProgramText read(const std::vector<SourceFile>& files,
                   const ReadSettings& settings) const override {
    return read_urscript(files, settings);
  }

  std::vector<TextEdit> edits(const ProgramText& text,
                              const std::vector<Eigen::Isometry3d>& poses) const override {
    return edits_of_urscript(text, poses);
  }
  std::vector<TextEdit> lines(const ProgramText& text,
                              const std::vector<ArcLines>& arcs) const override {
    return lines_of_urscript(text, arcs);
  }
};

}  // namespace

const Language& urscript() {
  static const Urscript language;
  return language;
}

}  // namespace tool_path_programs
