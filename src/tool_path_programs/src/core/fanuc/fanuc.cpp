// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "fanuc/fanuc.h"

#include "fanuc/fanuc_writer.h"
#include "fanuc_reader/fanuc_reader.h"

namespace tool_path_programs {
namespace {

class Fanuc : public Language {
 public:
  std::string name() const override { return "fanuc"; }
  std::string title() const override { return "FANUC TP (LS)"; }
  std::vector<std::string> extensions() const override { return {".ls"}; }

  WrittenProgram write(const Program& program, const WriteSettings& settings) const override {
    return write_fanuc(program, settings);
  }
  Unsaid unsaid(const WriteSettings& settings) const override {
    return {!fanuc_has_corner_regions(settings), false};
  }
  ProgramText read(const std::vector<SourceFile>& files,
                   const ReadSettings& settings) const override {
    return read_fanuc(files, settings);
  }
  std::vector<TextEdit> edits(const ProgramText& text,
                              const std::vector<Eigen::Isometry3d>& poses) const override {
    return fanuc_edits(text, poses);
  }
  std::vector<TextEdit> lines(const ProgramText& text,
                              const std::vector<ArcLines>& arcs) const override {
    return fanuc_lines(text, arcs);
  }
  bool turns_by_via() const override { return true; }
};

}  // namespace

const Language& fanuc() {
  static const Fanuc language;
  return language;
}

}  // namespace tool_path_programs
