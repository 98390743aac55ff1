// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "clouds/ply/ply_body.h"

#include <fmt/format.h>

#include "scan_cell_common/errors/errors.h"

namespace scan_cell_common {

void refuse_truncated(const std::string& source, const PlyElement& element, std::uint64_t read) {
  throw FileError(source,
                  fmt::format("truncated: it has {} of {} of the element '{}'", read, element.count,
                              excerpt(element.name)),
                  "write the file again");
}

void check_count(const PlyElement& element, std::size_t min_size, std::size_t left,
                 const std::string& source) {
  if (element.count <= left / min_size) return;
  throw FileError(
      source,
      fmt::format("truncated: its header promises {} of the element '{}', but only {} bytes follow",
                  element.count, excerpt(element.name), left),
      "write the file again");
}

double AsciiPlyBody::parsed(Value value) const {
  const std::optional<double> number = parse_number(*value);
  if (!number) throw FileError(lines_.where(), "'" + excerpt(*value) + "'", "give a number");
  return *number;
}

float AsciiPlyBody::number(Value value, const PlyProperty&) const {
  return to_float(parsed(value));
}

void AsciiPlyBody::append(Value value, const PlyProperty& property, FieldedCloud& carried) const {
  append_scalar(parsed(value), property.type, carried);
}

void AsciiPlyBody::list(Value value, const PlyProperty& property,
                        std::vector<std::uint64_t>& numbers) const {
  numbers.clear();
  const std::uint64_t length = *parse_count(*value);  // split() has checked it
  for (std::uint64_t i = 1; i <= length; ++i) {
    const std::optional<std::uint64_t> number = parse_count(value[i]);
    if (!number) {
      throw FileError(lines_.where(), "'" + excerpt(value[i]) + "'",
                      "give whole numbers from 0 for '" + excerpt(property.name) + "'");
    }
    numbers.push_back(*number);
  }
}

void AsciiPlyBody::end() {
  if (!lines_.next_filled()) return;
  throw FileError(lines_.where(), "more than the header promises", "correct the header");
}

void AsciiPlyBody::split(const PlyElement& element) {
  const std::vector<std::string_view>& words = lines_.words();
  values_.clear();
  std::size_t at = 0;
  for (const PlyProperty& property : element.properties) {
    if (at >= words.size()) refuse_row(element);
    values_.push_back(&words[at++]);
    if (!property.is_list) continue;
    const std::optional<std::uint64_t> length = parse_count(*values_.back());
    if (!length || *length > words.size() - at) refuse_row(element);
    at += *length;
  }
  if (at != words.size()) refuse_row(element);
}

void AsciiPlyBody::refuse_row(const PlyElement& element) const {
  throw FileError(
      lines_.where(), fmt::format("{} values", lines_.words().size()),
      fmt::format("give as many as the header names for each '{}'", excerpt(element.name)));
}

void BinaryPlyBody::list(Value value, const PlyProperty& property,
                         std::vector<std::uint64_t>& numbers) const {
  numbers.clear();
  const std::uint64_t length = whole(value, property.count_type);
  const char* place = value + size_of(property.count_type);
  for (std::uint64_t i = 0; i < length; ++i, place += size_of(property.type))
    numbers.push_back(whole(place, property.type));
}

void BinaryPlyBody::end() const {
  if (bytes_.find_first_not_of(std::string_view("\0 \t\r\n", 5), at_) == std::string_view::npos)
    return;
  throw FileError(source_,
                  fmt::format("{} bytes more than its header promises", bytes_.size() - at_),
                  "write the file again");
}

const char* BinaryPlyBody::next(const PlyProperty& property, const PlyElement& element,
                                std::uint64_t row) {
  const char* const value = advance(property.min_size(), element, row);
  if (property.is_list) {
    advance(whole(value, property.count_type) * size_of(property.type), element, row);
  }
  return value;
}

const char* BinaryPlyBody::advance(std::uint64_t size, const PlyElement& element,
                                   std::uint64_t row) {
  if (size > bytes_.size() - at_) refuse_truncated(source_, element, row);
  const char* const place = bytes_.data() + at_;
  at_ += size;
  return place;
}

/// A negative number becomes one larger than any file or, in int8, than any list of 127.
std::uint64_t BinaryPlyBody::whole(const char* value, Scalar type) const {
  switch (type) {
    case Scalar::kInt8:
    case Scalar::kUint8:
      return load_as<std::uint8_t>(value, big_endian_);
    case Scalar::kInt16:
    case Scalar::kUint16:
      return load_as<std::uint16_t>(value, big_endian_);
    default:
      return load_as<std::uint32_t>(value, big_endian_);
  }
}

}  // namespace scan_cell_common
