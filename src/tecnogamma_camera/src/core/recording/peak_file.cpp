// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tecnogamma_camera/peak_file.h"

#include <cmath>
#include <iomanip>
#include <sstream>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/csv_reader.h"
#include "scan_cell_common/files/files.h"

namespace tecnogamma_camera {

void save_peaks(const std::string& path, const PeakProfile& profile) {
  std::ostringstream file;
  file << "row,position,width,intensity\n" << std::fixed;
  for (int i = 0; i < profile.rows(); ++i) {
    if (std::isnan(profile.position[i])) continue;
    file << profile.first_row + i << ',' << std::setprecision(4) << profile.position[i] << ','
         << std::setprecision(2) << profile.width[i] << ',' << std::setprecision(1)
         << profile.intensity[i] << '\n';
  }
  scan_cell_common::save_text(path, file.str());
}

PeakProfile load_peaks(const std::string& path) {
  return parse_peaks(scan_cell_common::read_file(path), path);
}

PeakProfile parse_peaks(const std::string& text, const std::string& name) {
  constexpr int kMaxRows = 65536;  // chosen: more than any sensor has
  scan_cell_common::CsvReader table(text, name);
  if (!table.next() ||
      table.fields() != std::vector<std::string_view>{"row", "position", "width", "intensity"}) {
    throw scan_cell_common::UnusableInput(name, "not a table of peaks",
                                          "begin with the header row,position,width,intensity");
  }
  PeakProfile profile;
  int last = -1;
  while (table.next()) {
    table.expect_fields(4);
    const double row = table.number(0);
    if (row != std::floor(row) || row <= last || row >= kMaxRows)
      table.refuse("row " + std::string(table.field(0)), "give whole numbers in ascending order");
    if (last < 0) profile.first_row = static_cast<int>(row);
    last = static_cast<int>(row);
    const int size = last - profile.first_row;
    for (auto* values : {&profile.position, &profile.width, &profile.intensity})
      values->resize(size, kNoPeak);
    profile.position.push_back(static_cast<float>(table.number(1)));
    profile.width.push_back(static_cast<float>(table.number(2)));
    profile.intensity.push_back(static_cast<float>(table.number(3)));
  }
  return profile;
}

}  // namespace tecnogamma_camera
