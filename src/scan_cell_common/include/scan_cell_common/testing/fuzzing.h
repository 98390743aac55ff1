// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace scan_cell_common {

/// Something that has to stand any bytes.
struct FuzzTarget {
  std::string name;                //!< for --target
  std::vector<std::string> seeds;  //!< valid inputs, to be changed
  std::vector<std::string> words;  //!< that mean something in this format

  /// Returns where it could use the bytes, throws an Error where not; all else is a fault.
  std::function<void(const std::string& bytes)> run;

  std::uint64_t cost = 1;  //!< the command makes so many times fewer runs
};

/// A target did what it must not.
struct FuzzFault : std::logic_error {
  using std::logic_error::logic_error;
};

/// @throw FuzzFault unless the promise was kept
void promise(bool kept, const std::string& what);

/// What became of the inputs.
struct FuzzCount {
  std::uint64_t taken = 0;    //!< read without an error
  std::uint64_t refused = 0;  //!< with a typed error
};

/// The input of one run: a seed with a few changes (bits flipped, blocks and lines lost, doubled
/// and swapped, cut off, numbers and words replaced). The same on every machine.
std::string fuzz_input(const FuzzTarget& target, std::uint64_t seed, std::uint64_t run);

/// Runs one input.
/// @throw FuzzFault if it ends otherwise than returning or with an Error
void fuzz_once(const FuzzTarget& target, const std::string& bytes, FuzzCount& count);

/// @throw FuzzFault naming the run
FuzzCount fuzz(const FuzzTarget& target, std::uint64_t seed, std::uint64_t runs);

/// The command of a fuzzer: options --target, --runs, --seed, --first, --save, --seeds. Ends with 1
/// at a fault, a crash, a run of more than 10 s of processor time, or one that takes more than 2
/// GiB, and names the run.
int fuzz_main(int argc, char** argv, const std::vector<FuzzTarget>& targets);

/// For libFuzzer's entry point: runs the target that the environment variable FUZZ_TARGET names.
int fuzz_bytes(const std::vector<FuzzTarget>& targets, const std::uint8_t* data, std::size_t size);

}  // namespace scan_cell_common
