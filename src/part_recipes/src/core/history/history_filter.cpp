// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "history/history_filter.h"

#include <array>
#include <regex>

#include "record/run_record.h"
#include "scan_cell_common/errors/errors.h"

namespace part_recipes {
namespace {

using scan_cell_common::InvalidParameter;

/// The number; 0 if that part is left out.
int number(const std::ssub_match& digits) {
  return digits.matched ? std::stoi(digits.str()) : 0;
}

int days(int year, int month) {
  constexpr std::array<int, 13> kDays = {0, 31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
  const bool leap = (year % 4 == 0 && year % 100 != 0) || year % 400 == 0;
  return kDays.at(static_cast<std::size_t>(month)) + (month == 2 && leap ? 1 : 0);
}

std::string checked_time(const std::string& name, const std::string& text) {
  if (!is_time(text))
    throw InvalidParameter(name, "'" + text + "'",
                           "give a time in UTC such as 2026-11-25 or 2026-11-25T12:13:14");
  return text.back() == 'Z' ? text.substr(0, text.size() - 1) : text;
}

}  // namespace

bool is_time(const std::string& text) {
  static const std::regex kTime(
      "([0-9]{4})(-([0-9]{2})(-([0-9]{2})(T([0-9]{2})(:([0-9]{2})(:([0-9]{2})([.][0-9]+)?)?)?Z?)?)?"
      ")?");
  std::smatch parts;
  if (!std::regex_match(text, parts, kTime)) return false;
  const int month = parts[3].matched ? number(parts[3]) : 1;
  const int day = parts[5].matched ? number(parts[5]) : 1;
  constexpr int kLeapSecond = 60;
  return month >= 1 && month <= 12 && day >= 1 && day <= days(number(parts[1]), month) &&
         number(parts[7]) <= 23 && number(parts[9]) <= 59 && number(parts[11]) <= kLeapSecond;
}

bool is_whole_time(const std::string& text) {
  constexpr std::size_t kShortest = sizeof("2026-11-25T12:13:14Z") - 1;
  return text.size() >= kShortest && text.back() == 'Z' && is_time(text);
}

HistoryFilter checked(HistoryFilter filter) {
  if (filter.since) filter.since = checked_time("since", *filter.since);
  // '~' sorts after everything that can follow in a time.
  if (filter.until) filter.until = checked_time("until", *filter.until) + "~";
  if (filter.state) {
    const std::string& state = *filter.state;
    if (state != to_string(RunState::kAccepted) && state != to_string(RunState::kRefused) &&
        state != to_string(RunState::kUnusable))
      throw InvalidParameter("state", "'" + state + "'", "give accepted, refused or unusable");
  }
  if (filter.limit == 0) throw InvalidParameter("limit", "0", "give 1 or more");
  return filter;
}

}  // namespace part_recipes
