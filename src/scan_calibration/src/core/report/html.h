// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace scan_calibration {

/// Text with the special characters of HTML escaped.
std::string escaped(const std::string& text);

/// A number with this many digits after the point; "-" for NaN.
std::string rounded(double value, int digits);

/// A table: header and rows with the same number of cells, all plain text.
/// @param classes of the rows, for the page's style; may be empty
std::string html_table(const std::vector<std::string>& header,
                       const std::vector<std::vector<std::string>>& rows,
                       const std::vector<std::string>& classes = {});

/// A self-contained page. @param body HTML
std::string html_page(const std::string& title, const std::string& body);

}  // namespace scan_calibration
