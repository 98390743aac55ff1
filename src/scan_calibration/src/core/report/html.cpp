// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "report/html.h"

#include <cmath>
#include <cstdio>

namespace scan_calibration {

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

std::string rounded(double value, int digits) {
  if (!std::isfinite(value)) return "-";
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

std::string html_table(const std::vector<std::string>& header,
                       const std::vector<std::vector<std::string>>& rows) {
  const auto row = [](const std::vector<std::string>& cells, const std::string& tag) {
    std::string text = "<tr>";
    for (const std::string& cell : cells)
      text += "<" + tag + ">" + cell + "</" + tag + ">";
    return text + "</tr>\n";
  };
  std::string text = "<table>\n" + row(header, "th");
  for (const auto& cells : rows)
    text += row(cells, "td");
  return text + "</table>\n";
}

std::string html_page(const std::string& title, const std::string& body) {
  return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" +
         escaped(title) +
         "</title>\n<style>\n"
         "body { font: 15px/1.45 sans-serif; max-width: 60em; margin: 2em auto; padding: 0 1em; "
         "color: #222 }\n"
         "table { border-collapse: collapse; margin: 0.8em 0 }\n"
         "th, td { border-bottom: 1px solid #ccc; padding: 0.2em 0.8em; text-align: right }\n"
         "th:first-child, td:first-child { text-align: left }\n"
         ".passed { color: #186a18 } .failed { color: #b01818 }\n"
         "figure { margin: 1.2em 0 } figcaption { color: #555 } img { max-width: 100% }\n"
         "</style></head><body>\n<h1>" +
         escaped(title) + "</h1>\n" + body + "</body></html>\n";
}

}  // namespace scan_calibration
