// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "report/html.h"

#include <fmt/core.h>

#include <cmath>

namespace scan_calibration {
namespace {

constexpr const char* kPage = R"(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>{0}</title>
<style>
body {{ font: 15px/1.45 sans-serif; max-width: 60em; margin: 2em auto; padding: 0 1em; color: #222 }}
table {{ border-collapse: collapse; margin: 0.8em 0 }}
th, td {{ border-bottom: 1px solid #ccc; padding: 0.2em 0.8em; text-align: right }}
th:first-child, td:first-child {{ text-align: left }}
.passed {{ color: #186a18 }} .failed {{ color: #b01818 }}
figure {{ margin: 1.2em 0 }} figcaption {{ color: #555 }} svg {{ max-width: 100% }}
</style></head><body>
<h1>{0}</h1>
{1}</body></html>
)";

}  // namespace

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text)
    result += c == '&'   ? "&amp;"
              : c == '<' ? "&lt;"
              : c == '>' ? "&gt;"
              : c == '"' ? "&quot;"
                         : std::string(1, c);
  return result;
}

std::string rounded(double value, int digits) {
  return std::isfinite(value) ? fmt::format("{:.{}f}", value, digits) : "-";
}

std::string html_table(const std::vector<std::string>& header,
                       const std::vector<std::vector<std::string>>& rows,
                       const std::vector<std::string>& classes) {
  std::string text = "<table>\n<tr>";
  for (const std::string& cell : header)
    text += "<th>" + escaped(cell) + "</th>";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    text +=
        i < classes.size() ? fmt::format("</tr>\n<tr class=\"{}\">", classes[i]) : "</tr>\n<tr>";
    for (const std::string& cell : rows[i])
      text += "<td>" + escaped(cell) + "</td>";
  }
  return text + "</tr>\n</table>\n";
}

std::string html_page(const std::string& title, const std::string& body) {
  return fmt::format(kPage, escaped(title), body);
}

}  // namespace scan_calibration
