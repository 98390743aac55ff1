// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "fanuc/fanuc.h"
#include "gcode/gcode.h"
#include "krl/krl.h"
#include "pdl2/pdl2.h"
#include "rapid/rapid.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"
#include "tool_path_programs/language.h"
#include "urscript/urscript.h"

namespace tool_path_programs {

const std::vector<const Language*>& languages() {
  static const std::vector<const Language*> all = {&fanuc(), &gcode(), &krl(),
                                                   &pdl2(),  &rapid(), &urscript()};
  return all;
}

const Language& language_named(const std::string& name) {
  std::string names;
  for (const Language* language : languages()) {
    if (language->name() == name) return *language;
    names += (names.empty() ? "" : ", ") + language->name();
  }
  throw scan_cell_common::InvalidParameter("language", name, "give one of " + names);
}

const Language* language_of(const std::string& file) {
  const std::string extension = scan_cell_common::extension_of(file);
  const auto found =
      std::find_if(languages().begin(), languages().end(), [&](const Language* language) {
        const std::vector<std::string> extensions = language->extensions();
        return std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
      });
  return found == languages().end() ? nullptr : *found;
}

}  // namespace tool_path_programs
