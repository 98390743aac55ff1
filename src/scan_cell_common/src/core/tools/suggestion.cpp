// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/suggestion.h"

#include <algorithm>

#include "scan_cell_common/errors/text.h"

namespace scan_cell_common {
namespace {

std::string plain(const std::string& word) {
  std::string text = lower_case(word.substr(std::min(word.find_first_not_of('-'), word.size())));
  std::replace(text.begin(), text.end(), '_', '-');
  return text;
}

/// Number of letters lost, added, changed, or swapped with their neighbour.
std::size_t distance(const std::string& one, const std::string& other) {
  std::vector<std::size_t> before, last(other.size() + 1), row(other.size() + 1);
  for (std::size_t k = 0; k <= other.size(); ++k)
    last[k] = k;
  for (std::size_t i = 1; i <= one.size(); ++i) {
    row[0] = i;
    for (std::size_t k = 1; k <= other.size(); ++k) {
      const std::size_t change = one[i - 1] == other[k - 1] ? 0 : 1;
      row[k] = std::min({last[k] + 1, row[k - 1] + 1, last[k - 1] + change});
      const bool swapped =
          i > 1 && k > 1 && one[i - 1] == other[k - 2] && one[i - 2] == other[k - 1];
      if (swapped) row[k] = std::min(row[k], before[k - 2] + 1);
    }
    before = last;
    last = row;
  }
  return last.back();
}

}  // namespace

std::string nearest_name(const std::string& word, const std::vector<std::string>& names) {
  constexpr std::size_t kLettersAFault = 3;  // one fault in this many letters may be a typing error
  const std::string typed = plain(word);
  std::string nearest;
  std::size_t least = std::max<std::size_t>(1, typed.size() / kLettersAFault) + 1;
  for (const std::string& name : names) {
    const std::size_t faults = distance(typed, plain(name));
    // a one-letter word is near to every other one
    if (faults >= least || faults >= typed.size()) continue;
    least = faults;
    nearest = name;
  }
  if (!nearest.empty() || typed.size() < 2) return nearest;
  const auto begun = std::find_if(names.begin(), names.end(), [&](const std::string& name) {
    return plain(name).compare(0, typed.size(), typed) == 0;
  });
  return begun == names.end() ? "" : *begun;
}

}  // namespace scan_cell_common
