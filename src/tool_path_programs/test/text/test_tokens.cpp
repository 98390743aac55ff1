// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "scan_cell_common/errors/errors.h"
#include "text/token_reader.h"

namespace tool_path_programs {
namespace {

const LexicalRules kRules = {{";", "--"}, "\"", "$"};

TEST(Tokens, FallIntoKindsWithTheirPlaces) {
  const SourceFile file{"a.src", "$VEL.CP = -.5e1 ; slow\r\nPTP {X 1}"};
  const auto tokens = tokens_of(file, kRules);
  std::vector<std::string> texts;
  for (const Token& token : tokens)
    texts.emplace_back(token.text);
  EXPECT_EQ(texts, (std::vector<std::string>{"$VEL", ".", "CP", "=", "-", ".5e1", "; slow", "\n",
                                             "PTP", "{", "X", "1", "}", ""}));
  EXPECT_EQ(tokens[5].number, 5);
  EXPECT_EQ(tokens[8].line, 2u);
  EXPECT_EQ(tokens[8].offset, 24u);
}

TEST(Tokens, TextMayHoldMarksOfCommentsAndQuotes) {
  const SourceFile file{"a.src", "\"a;b\"\"c\" x"};
  const auto tokens = tokens_of(file, kRules);
  EXPECT_EQ(tokens[0].text, "\"a;b\"\"c\"");
  EXPECT_EQ(tokens[1].text, "x");
}

TEST(Tokens, OpenQuoteIsRefusedWithFileAndLine) {
  try {
    tokens_of({"a.src", "\n\"open\n"}, kRules);
    FAIL();
  } catch (const scan_cell_common::UnusableInput& error) {
    EXPECT_EQ(error.thing(), "a.src, line 2");
  }
}

TEST(TokenReader, NumberIncludesItsSign) {
  const SourceFile file{"a.src", "X ; c\n -12.5 , Y"};
  const auto tokens = tokens_of(file, kRules);
  TokenReader reader(file, 0, tokens);
  EXPECT_TRUE(reader.accept("x"));
  EXPECT_TRUE(reader.at_line_end());
  reader.skip_line();
  const NumberText number = reader.number();
  EXPECT_EQ(number.value, -12.5);
  EXPECT_EQ(file.text.substr(number.offset, number.length), "-12.5");
  reader.expect(',');
  EXPECT_EQ(reader.place().line, 2u);
}

TEST(TokenReader, GoesBackToWhereItWas) {
  const SourceFile file{"a.src", "A ; c\nB C"};
  const auto tokens = tokens_of(file, kRules);
  TokenReader reader(file, 0, tokens);
  reader.next();
  const std::size_t position = reader.position();
  reader.skip_line();
  EXPECT_EQ(reader.name(), "B");
  reader.go_to(position);
  EXPECT_TRUE(reader.at_line_end());
}

TEST(TokenReader, SaysWhatStandsThereAndWhatShould) {
  const SourceFile file{"a.src", "A1 B"};
  const auto tokens = tokens_of(file, kRules);
  TokenReader reader(file, 0, tokens);
  reader.next();
  try {
    reader.number();
    FAIL();
  } catch (const scan_cell_common::UnusableInput& error) {
    EXPECT_EQ(error.thing(), "a.src, line 1");
    EXPECT_EQ(error.value(), "B");
  }
}

}  // namespace
}  // namespace tool_path_programs
