// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "krl/krl.h"

#include "krl/krl_writer.h"
#include "krl_reader/krl_reader.h"

namespace tool_path_programs {
namespace {

class Krl : public Language {
 public:
  std::string name() const override { return "krl"; }
  std::string title() const override { return "KUKA KRL (KRC4, KRC2)"; }
  std::vector<std::string> extensions() const override { return {".src", ".dat"}; }
  WrittenProgram write(const Program& program, const WriteSettings& settings) const override {
    return write_krl(program, settings);
  }
  Unsaid unsaid(const WriteSettings&) const override { return {}; }
  ProgramText read(const std::vector<SourceFile>& files,
                   const ReadSettings& settings) const override {
    return read_krl(files, settings);
  }
  std::vector<TextEdit> edits(const ProgramText& text,
                              const std::vector<Eigen::Isometry3d>& poses) const override {
    return krl_edits(text, poses);
  }
  std::vector<TextEdit> lines(const ProgramText& text,
                              const std::vector<ArcLines>& arcs) const override {
    return krl_lines(text, arcs);
  }
};

}  // namespace

const Language& krl() {
  static const Krl language;
  return language;
}

}  // namespace tool_path_programs
