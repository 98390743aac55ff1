// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

namespace scan_cell_common {

/// Base of every error of the suite: the thing it is about, its value, and the cure. what() reads
/// "THING: VALUE; CURE".
class Error : public std::runtime_error {
 public:
  /// @param thing what the error is about, such as a parameter's name or a file's path
  /// @param value the value of the thing
  /// @param cure what to do about it
  Error(const std::string& thing, const std::string& value, const std::string& cure);

  const std::string& thing() const { return thing_; }  //!< what it is about
  const std::string& value() const { return value_; }  //!< its value
  const std::string& cure() const { return cure_; }    //!< what to do

 private:
  std::string thing_;
  std::string value_;
  std::string cure_;
};

/// A parameter is missing, unknown, of the wrong type or out of range. thing() is its name.
class InvalidParameter : public Error {
 public:
  using Error::Error;  //!< thing, value, cure
};

/// A file cannot be read or written. thing() is its path.
class FileError : public Error {
 public:
  using Error::Error;  //!< thing, value, cure
};

/// Data that was read but cannot be used: an empty cloud, a path of NaN, a singular plane.
class UnusableInput : public Error {
 public:
  using Error::Error;  //!< thing, value, cure
};

/// A device, a controller or a peer cannot be reached, or was lost.
class ConnectionError : public Error {
 public:
  using Error::Error;  //!< thing, value, cure
};

/// A peer sent what the protocol does not allow.
class ProtocolError : public Error {
 public:
  using Error::Error;  //!< thing, value, cure
};

/// A request is not possible now, or not allowed: nothing was done.
class Refused : public Error {
 public:
  using Error::Error;  //!< thing, value, cure
};

}  // namespace scan_cell_common
