// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "history/export/aqdef.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "scan_cell_common/pose/units.h"

namespace part_recipes {
namespace {

using scan_cell_common::kMillimetres;

// Longest texts [letters] that the format recommends for these fields
constexpr std::size_t kPartNumber = 30;   // K1001
constexpr std::size_t kDescription = 80;  // K1002, K2002
constexpr std::size_t kText = 255;        // K0009

// Attributes of a value, K0002
constexpr int kValid = 0;
constexpr int kInvalid = 129;  // shown, and not counted
constexpr int kMissing = 256;  // deleted when it is read

/// What is measured on a part.
struct Characteristic {
  std::string name;
  std::string unit;  // empty: none
  int decimals = 5;
  double factor = kMillimetres;
  double tolerance = 0;  // [m] around 0; 0: none
  std::function<std::optional<double>(const RunFigures&)> value;
};

/// A recipe, with the number of its first characteristic in the file.
struct Part {
  std::size_t first = 0;
  std::vector<Characteristic> characteristics;
};

/// The text in one line, at most this many letters of UTF-8.
std::string one_line(const std::string& text, std::size_t longest) {
  std::string result;
  std::size_t letters = 0;
  for (const char byte : text) {
    const bool begins_letter = (static_cast<unsigned char>(byte) & 0xc0U) != 0x80U;
    if (begins_letter && ++letters > longest) break;
    const bool is_control = static_cast<unsigned char>(byte) < 0x20 || byte == 0x7f;
    result += is_control ? ' ' : byte;
  }
  return result;
}

std::vector<Characteristic> characteristics_of(const std::string& recipe,
                                               const std::vector<const RunRecord*>& runs) {
  std::set<std::string> places;
  double tolerance = 0;
  for (const RunRecord* const run : runs) {
    if (run->recipe_name != recipe) continue;
    if (run->tolerance > 0) tolerance = run->tolerance;
    for (const auto& [name, deviation] : run->figures.places)
      places.insert(name);
  }
  constexpr int kScaleDecimals = 6;
  std::vector<Characteristic> all = {
      {"scale", "", kScaleDecimals, 1, 0, [](const RunFigures& run) { return run.scale; }},
      {"rms", "mm", 5, kMillimetres, 0, [](const RunFigures& run) { return run.rms; }}};
  for (const std::string& place : places) {
    all.push_back({place, "mm", 5, kMillimetres, tolerance,
                   [place](const RunFigures& run) -> std::optional<double> {
                     const auto found = run.places.find(place);
                     return found != run.places.end() ? found->second : std::nullopt;
                   }});
  }
  return all;
}

/// 2026-11-25T12:13:14.123Z as 25.11.2026/12:13:14.
std::string date(const std::string& time) {
  return fmt::format("{}.{}.{}/{}", time.substr(8, 2), time.substr(5, 2), time.substr(0, 4),
                     time.substr(11, 8));
}

class Writer {
 public:
  void line(const std::string& key, std::size_t index, const std::string& value) {
    text_ += fmt::format("{}/{} {}\r\n", key, index, value);
  }

  void describe(std::size_t number, const Characteristic& of) {
    line("K2001", number, fmt::format("{}", number));
    line("K2002", number, one_line(of.name, kDescription));
    line("K2004", number, "0");  // variable
    line("K2022", number, fmt::format("{}", of.decimals));
    if (of.tolerance > 0) {
      const double limit = of.tolerance * of.factor;
      line("K2101", number, "0");
      line("K2110", number, fmt::format("{:.{}f}", -limit, of.decimals));
      line("K2111", number, fmt::format("{:.{}f}", limit, of.decimals));
    }
    if (!of.unit.empty()) line("K2142", number, of.unit);
  }

  void value(std::size_t number, const Characteristic& of, const RunRecord& run) {
    const auto value = of.value(run.figures);
    const int known = run.state == RunState::kAccepted ? kValid : kInvalid;
    line("K0001", number, fmt::format("{:.{}f}", value.value_or(0) * of.factor, of.decimals));
    line("K0002", number, fmt::format("{}", value ? known : kMissing));
    line("K0004", number, date(run.started));
    line("K0009", number, one_line(run.id, kText));
  }

  /// The file, which begins with the number of characteristics.
  std::string finished(std::size_t characteristics) const {
    const bool is_ascii = std::all_of(text_.begin(), text_.end(), [](char byte) {
      return static_cast<unsigned char>(byte) < 0x80;
    });
    return fmt::format("{}K0100 {}\r\n", is_ascii ? "" : "\xef\xbb\xbf", characteristics) + text_;
  }

 private:
  std::string text_;
};

}  // namespace

std::string to_aqdef(const std::vector<HistoryRun>& all) {
  std::vector<const RunRecord*> runs;
  for (const HistoryRun& run : all) {
    if (run.record.again_of.empty()) runs.push_back(&run.record);
  }
  Writer writer;
  std::map<std::string, Part> parts;
  std::size_t count = 0;
  for (const RunRecord* const run : runs) {
    const auto [part, is_new] = parts.try_emplace(run->recipe_name);
    if (!is_new) continue;
    part->second = {count + 1, characteristics_of(run->recipe_name, runs)};
    writer.line("K1001", parts.size(), one_line(run->recipe_name, kPartNumber));
    writer.line("K1002", parts.size(), one_line(run->recipe_name, kDescription));
    for (const Characteristic& characteristic : part->second.characteristics)
      writer.describe(++count, characteristic);
  }
  for (const RunRecord* const run : runs) {
    const Part& part = parts.at(run->recipe_name);
    for (std::size_t i = 0; i < part.characteristics.size(); ++i)
      writer.value(part.first + i, part.characteristics[i], *run);
  }
  return writer.finished(count);
}

}  // namespace part_recipes
