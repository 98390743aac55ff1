// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pdl2/pdl2.h"

#include "pdl2/pdl2_writer.h"
#include "pdl2_reader/pdl2_reader.h"

namespace tool_path_programs {
namespace {

class Pdl2 : public Language {
 public:
  std::string name() const override { return "pdl2"; }
  std::string title() const override { return "Comau PDL2 (C5G, C4G)"; }
  std::vector<std::string> extensions() const override { return {".pdl", ".lsv"}; }
  WrittenProgram write(const Program& program, const WriteSettings& settings) const override {
    return write_pdl2(program, settings);
  }
  Unsaid unsaid(const WriteSettings&) const override { return {}; }
  ProgramText read(const std::vector<SourceFile>& files,
                   const ReadSettings& settings) const override {
    return read_pdl2(files, settings);
  }
  std::vector<TextEdit> edits(const ProgramText& text,
                              const std::vector<Eigen::Isometry3d>& poses) const override {
    return pdl2_edits(text, poses);
  }
  std::vector<TextEdit> lines(const ProgramText& text,
                              const std::vector<ArcLines>& arcs) const override {
    return pdl2_lines(text, arcs);
  }
  bool turns_by_via() const override { return true; }
};

}  // namespace

const Language& pdl2() {
  static const Pdl2 language;
  return language;
}

}  // namespace tool_path_programs
