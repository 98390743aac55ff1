// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "tool_path_programs/program.h"
#include "tool_path_programs/source_text.h"

namespace tool_path_programs {

/// Settings for writing a program.
struct WriteSettings {
  std::size_t max_lines = 0;  //!< in a file or routine; 0: the limit of the language's controllers
  double max_speed_change = 0.01;  //!< greatest relative change when a speed is rounded
  /// Controller or dialect, where a language has several, such as c5g; empty: the first
  std::string dialect;
};

/// A written program and notes for the user.
struct WrittenProgram {
  std::vector<SourceFile> files;   //!< the main one first
  std::vector<std::string> notes;  //!< what was rounded, split or left to the controller's settings
};

/// Facts that a reader cannot find in the files.
struct ReadSettings {
  std::map<std::string, Eigen::Isometry3d> frames;  //!< [m] by the name used in the program
  std::set<std::string> calls_without_motion;       //!< routines known not to move the robot
  std::string dialect;                              //!< as in WriteSettings
};

/// A pose written as numbers in a program's text.
struct PoseText {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  //!< tip in the user frame [m]
  Place place;                                             //!< where the numbers are
  std::size_t offset = 0;  //!< of the first byte of the literal, in the file
};

/// A range of bytes in a file.
struct ByteRange {
  std::size_t begin = 0;  //!< first byte
  std::size_t end = 0;    //!< one past the last byte
};

/// The statement of an arc, split into the pieces needed to rewrite it as lines.
struct ArcText {
  ByteRange statement;  //!< without what follows it, such as a comment
  ByteRange word;       //!< that makes it an arc; empty: a setting does
  ByteRange via;        //!< with its comma or keyword
  ByteRange target;     //!< the arc's end
  ByteRange zone;       //!< in languages where each move has its own
};

/// Where a step of a program is in the text.
struct StepText {
  Place place;                      //!< of the statement
  std::optional<std::size_t> pose;  //!< of a move: index in ProgramText::poses
  std::optional<std::size_t> via;   //!< of a circular move: index in ProgramText::poses
  /// Of a circular move that can be rewritten as lines.
  std::optional<ArcText> arc = std::nullopt;
};

/// An arc to rewrite as lines.
struct ArcLines {
  std::size_t step = 0;                  //!< a circular move of the program
  Eigen::Isometry3d start;               //!< [m] in the move's user frame
  std::vector<Eigen::Isometry3d> poses;  //!< [m] in the same frame, in order, without the arc's end
};

/// A program that was read: its steps, and where they are in the text. Moves may share a pose.
struct ProgramText {
  std::vector<SourceFile> files;  //!< as given
  Program program;                //!< in the order of the motion, calls followed
  std::vector<StepText> steps;    //!< one for each of program.steps
  std::vector<PoseText> poses;    //!< of all moves
  std::string dialect;            //!< of the program, if the language has several
};

/// What a language leaves to the controller's settings or to the machine.
struct Unsaid {
  bool zones = false;         //!< zones are not lengths in the program
  bool orientations = false;  //!< the machine has no axes to turn the tool
};

/// A robot programming language. Objects hold no state; safe for use from several threads.
class Language {
 public:
  virtual ~Language() = default;

  virtual std::string name() const = 0;   //!< as used in options: krl
  virtual std::string title() const = 0;  //!< for display: KUKA KRL (KRC4)
  virtual std::vector<std::string> extensions()
      const = 0;  //!< of its files: .src, .dat; first main

  /// @throw scan_cell_common::UnusableInput naming the first waypoint that the language cannot
  /// express, and the cure
  /// @throw scan_cell_common::InvalidParameter if a setting is invalid
  virtual WrittenProgram write(const Program& program, const WriteSettings& settings) const = 0;

  /// What a program written with these settings leaves open.
  virtual Unsaid unsaid(const WriteSettings& settings) const = 0;

  /// @param files the main one first, then those that it calls or that hold its data
  /// @throw scan_cell_common::UnusableInput naming file and line of what cannot be resolved
  virtual ProgramText read(const std::vector<SourceFile>& files,
                           const ReadSettings& settings) const = 0;

  /// Edits that give the program these poses and change nothing else.
  /// @param text as returned by read()
  /// @param poses one for each of text.poses [m]
  /// @throw scan_cell_common::UnusableInput if the language cannot express one of them at its place
  virtual std::vector<TextEdit> edits(const ProgramText& text,
                                      const std::vector<Eigen::Isometry3d>& poses) const = 0;

  /// Edits that turn arcs into lines: the tool flies past each of the given poses and ends where
  /// the arc ends.
  /// @param text as returned by read(); the steps have an ArcText
  /// @param arcs no two of the same statement
  /// @throw scan_cell_common::UnusableInput if the language cannot express one of the poses there
  virtual std::vector<TextEdit> lines(const ProgramText& text,
                                      const std::vector<ArcLines>& arcs) const = 0;

  /// Whether the tool has the via's orientation when it passes the via. If not, the orientation
  /// there is interpolated between the arc's start and end.
  virtual bool turns_by_via() const { return false; }

  /// Whether edits() can move an arc. If not, arcs that move become lines.
  virtual bool moves_arcs() const { return true; }
};

/// All languages.
const std::vector<const Language*>& languages();

/// @throw scan_cell_common::InvalidParameter listing all names if no language has this one
const Language& language_named(const std::string& name);

/// The language of a file, by its extension; null: none has it.
const Language* language_of(const std::string& file);

}  // namespace tool_path_programs
