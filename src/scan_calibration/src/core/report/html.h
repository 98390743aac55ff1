// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace scan_calibration {

/// Text that stands for itself in HTML.
std::string escaped(const std::string& text);

/// A number for people: as many digits as are asked for after the point; "-" where it is none.
std::string rounded(double value, int digits);

/// A table: its header, then its rows, all of as many cells. Cells are HTML.
std::string html_table(const std::vector<std::string>& header,
                       const std::vector<std::vector<std::string>>& rows);

/// A page that needs nothing but itself and its pictures. @param body HTML
std::string html_page(const std::string& title, const std::string& body);

}  // namespace scan_calibration
