// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <clocale>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/errors/text.h"
#include "scan_cell_common/errors/utf8.h"

using namespace scan_cell_common;

TEST(Numbers, AreReadWholeOrNotAtAll) {
  EXPECT_EQ(parse_number("-1.5e-3"), -0.0015);
  EXPECT_EQ(parse_number("+2"), 2);
  for (const char* text : {"", "1 2", "1,5", "0x10", "+-1", "1m", "--1", "+"})
    EXPECT_FALSE(parse_number(text)) << text;
  EXPECT_EQ(parse_count("12"), 12U);
  for (const char* text : {"", "-1", "1.0", "99999999999999999999", "+1"})
    EXPECT_FALSE(parse_count(text)) << text;
}

TEST(Numbers, AreReadTheSameInEveryLocale) {
  const std::string before = std::setlocale(LC_NUMERIC, nullptr);
  for (const char* locale : {"de_DE.UTF-8", "it_IT.UTF-8", "fr_FR.UTF-8"})
    if (std::setlocale(LC_NUMERIC, locale) != nullptr) break;
  EXPECT_EQ(parse_number("0.5"), 0.5);
  EXPECT_FALSE(parse_number("0,5"));
  std::setlocale(LC_NUMERIC, before.c_str());
}

TEST(Excerpt, IsShortAndFitForATerminal) {
  EXPECT_EQ(excerpt("x\x1b[2J\n"), "x?[2J?");
  EXPECT_EQ(excerpt(std::string(1000000, 'a')).size(), 43U);
}

TEST(Utf8, IsToldFromOtherBytesByTheLine) {
  for (const char* good :
       {"", "a\n", "Ma\xc3\x9f", "\xef\xbb\xbfx", "\xf0\x9f\x94\xa7", "\xef\xbf\xbd"})
    EXPECT_NO_THROW(check_utf8(good, "f")) << good;
  const char* const overlong = "\xc0\xaf";
  const char* const surrogate = "\xed\xa0\x80";
  const char* const noncharacter = "\xef\xbf\xbf";
  const char* const cut = "x\xe2\x82";
  for (const char* bad : {overlong, surrogate, noncharacter, "\xef\xb7\x90", cut, "\xff\xfex"})
    EXPECT_THROW(check_utf8(bad, "f"), UnusableInput) << bad;
  const char* const latin_1 = "a\n\nGr\xf6\xdf\n";
  try {
    check_utf8(latin_1, "f", 5);
    ADD_FAILURE();
  } catch (const UnusableInput& error) {
    EXPECT_STREQ(error.what(), "f, line 7: not UTF-8; save it as UTF-8");
  }
}

TEST(LineReader, SplitsLinesHoweverTheyEnd) {
  const std::string text = "a  b\r\n\n\tc\nlast";
  LineReader lines(text, "file");
  ASSERT_TRUE(lines.next());
  EXPECT_EQ(lines.words(), (std::vector<std::string_view>{"a", "b"}));
  ASSERT_TRUE(lines.next_filled());
  EXPECT_EQ(lines.words(), (std::vector<std::string_view>{"c"}));
  EXPECT_EQ(lines.where(), "file, line 3");
  EXPECT_EQ(lines.left(), 4U);
  ASSERT_TRUE(lines.next());
  EXPECT_EQ(lines.words(), (std::vector<std::string_view>{"last"}));
  EXPECT_FALSE(lines.next());
}
