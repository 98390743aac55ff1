// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pdl2_reader/pdl2_reader.h"

#include "pdl2_reader/pdl2_run.h"

namespace tool_path_programs {

ProgramText read_pdl2(const std::vector<SourceFile>& files, const ReadSettings& settings) {
  ProgramText text;
  text.files = files;
  const Pdl2Source source(text.files);
  text.program.name = source.main().name;
  Pdl2Run(source, settings, text).run();
  return text;
}

}  // namespace tool_path_programs
