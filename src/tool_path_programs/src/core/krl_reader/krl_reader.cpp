// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "krl_reader/krl_reader.h"

#include "krl_reader/krl_run.h"

namespace tool_path_programs {

ProgramText read_krl(const std::vector<SourceFile>& files, const ReadSettings& settings) {
  ProgramText text;
  text.files = files;
  const KrlSource source(text.files);
  text.program.name = source.main().name;
  KrlRun(source, settings, text).run();
  return text;
}

}  // namespace tool_path_programs
