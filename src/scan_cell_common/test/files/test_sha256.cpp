// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/sha256.h"

namespace scan_cell_common {
namespace {

TEST(Sha256, IsThatOfFips180) {
  EXPECT_EQ(sha256_of("abc", "text"),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256_of("", "text"),
            "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST(Sha256, OfAFileThatIsMissingIsRefused) {
  EXPECT_THROW(sha256_of_file("/no/such/file"), FileError);
}

}  // namespace
}  // namespace scan_cell_common
