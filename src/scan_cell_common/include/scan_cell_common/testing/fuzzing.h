// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace scan_cell_common {

/// A function that must withstand any bytes.
struct FuzzTarget {
  std::string name;                //!< for --target
  std::vector<std::string> seeds;  //!< valid inputs, to be mutated
  std::vector<std::string> words;  //!< with a meaning in this format

  /// Returns if it could use the bytes, throws an Error if not; anything else is a fault.
  std::function<void(const std::string& bytes)> run;

  std::uint64_t cost = 1;  //!< the command makes this many times fewer runs
};

/// A target did something that it must not do.
struct FuzzFault : std::logic_error {
  using std::logic_error::logic_error;
};

/// @throw FuzzFault unless the promise was kept
void promise(bool kept, const std::string& what);

/// Results of the inputs.
struct FuzzCount {
  std::uint64_t taken = 0;    //!< read without an error
  std::uint64_t refused = 0;  //!< with a typed error
};

/// The input of one run: a seed with a few changes (bits flipped, blocks and lines removed, doubled
/// and swapped, cut off, numbers and words replaced). The same on every machine.
std::string fuzz_input(const FuzzTarget& target, std::uint64_t seed, std::uint64_t run);

/// Runs one input.
/// @throw FuzzFault if it neither returns nor throws an Error
void fuzz_once(const FuzzTarget& target, const std::string& bytes, FuzzCount& count);

/// @throw FuzzFault naming the run
FuzzCount fuzz(const FuzzTarget& target, std::uint64_t seed, std::uint64_t runs);

/// The command of a fuzzer: options --target, --runs, --seed, --first, --save, --seeds. Ends with 1
/// at a fault, a crash, a run of more than 10 s of processor time, or one that takes more than 2
/// GiB, and names the run.
int fuzz_main(int argc, char** argv, const std::vector<FuzzTarget>& targets);

/// For libFuzzer's entry point: runs the target named by the environment variable FUZZ_TARGET.
int fuzz_bytes(const std::vector<FuzzTarget>& targets, const std::uint8_t* data, std::size_t size);

}  // namespace scan_cell_common
