// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "edits/edits_targets.h"

#ifdef LIBFUZZER
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const auto targets = edits_targets();
  return scan_cell_common::fuzz_bytes(targets, data, size);
}
#else
int main(int argc, char** argv) {
  return scan_cell_common::fuzz_main(argc, argv, edits_targets());
}
#endif
