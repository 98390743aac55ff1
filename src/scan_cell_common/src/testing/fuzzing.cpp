// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/testing/fuzzing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "scan_cell_common/errors/errors.h"

namespace scan_cell_common {
namespace {

/// Numbers that often break readers.
const char* const kNasty[] = {"0",          "-1",         "1",          "2",
                              "3",          "7",          "255",        "256",
                              "65536",      "1000000000", "2147483647", "2147483648",
                              "4000000000", "4294967295", "4294967296", "18446744073709551615",
                              "1e9",        "1e30",       "1e-30",      "1e400",
                              "-0",         "nan",        "inf",        "-inf",
                              "0,5",        "0x10",       "+1",         ".",
                              "1.2.3"};

/// SplitMix64 (Steele, Lea and Flood 2014)
class Random {
 public:
  explicit Random(std::uint64_t state) : state_(state) {}

  std::uint64_t next() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }

  /// 0 .. end - 1
  std::size_t below(std::size_t end) { return next() % end; }

  template <class List>
  const auto& one_of(const List& list) {
    return *(std::begin(list) + static_cast<std::ptrdiff_t>(below(std::size(list))));
  }

 private:
  std::uint64_t state_;
};

struct Range {
  std::size_t begin;
  std::size_t size;
};

Range block(const std::string& bytes, Random& random) {
  constexpr std::size_t kLongest = 64;
  const std::size_t begin = random.below(bytes.size());
  return {begin, std::min(1 + random.below(kLongest), bytes.size() - begin)};
}

Range line(const std::string& bytes, Random& random) {
  const std::size_t at = random.below(bytes.size());
  const std::size_t before = at == 0 ? std::string::npos : bytes.rfind('\n', at - 1);
  const std::size_t begin = before == std::string::npos ? 0 : before + 1;
  const std::size_t end = std::min(bytes.find('\n', begin), bytes.size() - 1);
  return {begin, end + 1 - begin};
}

bool in_number(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '-' || c == '+';
}

void replace_word(std::string& bytes, const std::string& by, Random& random) {
  std::size_t begin = random.below(bytes.size());
  while (begin < bytes.size() && !in_number(bytes[begin]))
    ++begin;
  while (begin > 0 && in_number(bytes[begin - 1]))
    --begin;
  std::size_t end = begin;
  while (end < bytes.size() && in_number(bytes[end]))
    ++end;
  bytes.replace(begin, end - begin, by);
}

void swap_lines(std::string& bytes, Random& random) {
  Range one = line(bytes, random);
  Range other = line(bytes, random);
  if (one.begin > other.begin) std::swap(one, other);
  if (one.begin == other.begin) return;
  const std::string first = bytes.substr(one.begin, one.size);
  const std::string second = bytes.substr(other.begin, other.size);
  bytes.replace(other.begin, other.size, first);
  bytes.replace(one.begin, one.size, second);
}

/// Removes or doubles a piece.
/// @param by_line pieces are lines
void change_piece(std::string& bytes, bool by_line, bool remove, Random& random) {
  const Range piece = by_line ? line(bytes, random) : block(bytes, random);
  if (remove) {
    bytes.erase(piece.begin, piece.size);
    return;
  }
  const std::size_t place = by_line ? piece.begin : random.below(bytes.size());
  bytes.insert(place, bytes.substr(piece.begin, piece.size));
}

void change(std::string& bytes, const FuzzTarget& target, Random& random) {
  const std::size_t kind = random.below(12);
  switch (kind) {
    case 0:
      bytes[random.below(bytes.size())] ^= static_cast<char>(1U << random.below(8));
      break;
    case 1:
      bytes[random.below(bytes.size())] = static_cast<char>(random.next());
      break;
    case 2:
      bytes.resize(random.below(bytes.size()));
      break;
    case 3:
    case 4:
    case 5:
    case 6:
      change_piece(bytes, kind >= 5, kind % 2 == 1, random);
      break;
    case 7:
      swap_lines(bytes, random);
      break;
    case 8:
      bytes.insert(random.below(bytes.size()), random.one_of(target.words));
      break;
    case 9:
      replace_word(bytes, random.one_of(target.words), random);
      break;
    default:
      replace_word(bytes, random.one_of(kNasty), random);
      break;
  }
}

}  // namespace

void promise(bool kept, const std::string& what) {
  if (!kept) throw FuzzFault(what);
}

std::string fuzz_input(const FuzzTarget& target, std::uint64_t seed, std::uint64_t run) {
  constexpr std::size_t kMaxChanges = 5;
  Random random(Random(seed).next() ^ (run * 0xd1342543de82ef95));
  std::string bytes = random.one_of(target.seeds);
  const std::size_t changes = 1 + random.below(1 + random.below(kMaxChanges));
  for (std::size_t i = 0; i < changes && !bytes.empty(); ++i)
    change(bytes, target, random);
  return bytes;
}

void fuzz_once(const FuzzTarget& target, const std::string& bytes, FuzzCount& count) {
  try {
    target.run(bytes);
    ++count.taken;
  } catch (const Error&) {
    ++count.refused;
  } catch (const FuzzFault&) {
    throw;
  } catch (const std::exception& error) {
    throw FuzzFault(std::string("not an Error but: ") + error.what());
  }
}

FuzzCount fuzz(const FuzzTarget& target, std::uint64_t seed, std::uint64_t runs) {
  FuzzCount count;
  for (std::uint64_t run = 0; run < runs; ++run) {
    try {
      fuzz_once(target, fuzz_input(target, seed, run), count);
    } catch (const FuzzFault& fault) {
      throw FuzzFault(fmt::format("{}, seed {}, run {}: {}", target.name, seed, run, fault.what()));
    }
  }
  return count;
}

}  // namespace scan_cell_common
