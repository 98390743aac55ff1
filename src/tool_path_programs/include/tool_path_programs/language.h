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

/// How a program is written.
struct WriteSettings {
  std::size_t max_lines = 0;  //!< of a file or routine; 0: what the language's controllers take
  double max_speed_change = 0.01;  //!< share by which a speed may be rounded to what can be said
  /// Controller or dialect, where a language has several, such as c5g; empty: the first
  std::string dialect;
};

/// A program as files, and what the person should know.
struct WrittenProgram {
  std::vector<SourceFile> files;   //!< the main one first
  std::vector<std::string> notes;  //!< what was rounded, split or left to the controller's settings
};

/// What a reader cannot know from the files.
struct ReadSettings {
  std::map<std::string, Eigen::Isometry3d> frames;  //!< by the name that the program uses [m]
  std::set<std::string> calls_without_motion;       //!< routines that are known not to move
  std::string dialect;                              //!< as of WriteSettings
};

/// A pose that stands in a program's text as numbers.
struct PoseText {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  //!< tip in the user frame [m]
  Place place;                                             //!< where its numbers stand
  std::size_t offset = 0;  //!< of the first byte of what holds them, in the file
};

/// A piece of a file.
struct ByteRange {
  std::size_t begin = 0;  //!< of its first byte
  std::size_t end = 0;    //!< behind its last one
};

/// The statement of an arc, in pieces, where they are needed to say the arc as lines.
struct ArcText {
  ByteRange statement;  //!< without what follows it, such as a comment
  ByteRange word;       //!< that says that it is an arc; empty: a setting does
  ByteRange via;        //!< with the comma or word that belongs to it
  ByteRange target;     //!< where it leads to
  ByteRange zone;       //!< of languages whose moves each say one
};

/// Where a step of a program comes from.
struct StepText {
  Place place;                      //!< of the statement
  std::optional<std::size_t> pose;  //!< of a move: which of ProgramText::poses
  std::optional<std::size_t> via;   //!< of a circular move: as pose
  /// Of a circular move that can be said as lines.
  std::optional<ArcText> arc = std::nullopt;
};

/// An arc that is to be said as lines.
struct ArcLines {
  std::size_t step = 0;                  //!< of the program: a circular move
  Eigen::Isometry3d start;               //!< [m] in the move's user frame
  std::vector<Eigen::Isometry3d> poses;  //!< [m] there, too: those before its end
};

/// A program that was read: what it does, and where that stands. Two moves may refer to one pose.
struct ProgramText {
  std::vector<SourceFile> files;  //!< as they were given
  Program program;                //!< in the order of the motion, calls followed
  std::vector<StepText> steps;    //!< of each of program.steps
  std::vector<PoseText> poses;    //!< of all moves
  std::string dialect;            //!< that it is in, where the language has several
};

/// What a language leaves to the controller's settings, or to the machine.
struct Unsaid {
  bool zones = false;         //!< how far fly-by leaves a pose is not a length in the program
  bool orientations = false;  //!< the tool keeps its direction: the machine has no axes for it
};

/// A language of robots' programs. Objects hold no state; safe for use from several threads.
class Language {
 public:
  virtual ~Language() = default;

  virtual std::string name() const = 0;                  //!< as options name it: krl
  virtual std::string title() const = 0;                 //!< for a person: KUKA KRL (KRC4)
  virtual std::vector<std::string> endings() const = 0;  //!< of its files: .src, .dat; first main

  /// @throw scan_cell_common::UnusableInput naming the first waypoint that the language cannot say,
  /// and the cure
  /// @throw scan_cell_common::InvalidParameter if a setting makes no sense
  virtual WrittenProgram write(const Program& program, const WriteSettings& settings) const = 0;

  /// Of a program that is written so.
  virtual Unsaid unsaid(const WriteSettings& settings) const = 0;

  /// @param files the main one first, then those that it calls or that hold its data
  /// @throw scan_cell_common::UnusableInput naming file and line of what cannot be resolved
  virtual ProgramText read(const std::vector<SourceFile>& files,
                           const ReadSettings& settings) const = 0;

  /// What to change in the text so that its poses become these; all else stays.
  /// @param text as read() gave it
  /// @param poses one for each of text.poses [m]
  /// @throw scan_cell_common::UnusableInput if the language cannot say one of them where it stands
  virtual std::vector<TextEdit> edits(const ProgramText& text,
                                      const std::vector<Eigen::Isometry3d>& poses) const = 0;

  /// What to change in the text so that arcs become lines: to each of the poses, past which the
  /// tool flies, and to the end that the arc has.
  /// @param text as read() gave it; the steps have an ArcText
  /// @param arcs no two of one statement
  /// @throw scan_cell_common::UnusableInput if the language cannot say one of the poses there
  virtual std::vector<TextEdit> lines(const ProgramText& text,
                                      const std::vector<ArcLines>& arcs) const = 0;

  /// Whether the tool has the via's orientation when an arc passes it, not one between those of the
  /// arc's start and end.
  virtual bool turns_by_via() const { return false; }

  /// Whether edits() can change where an arc leads. If not, arcs that move become lines.
  virtual bool moves_arcs() const { return true; }
};

/// All of them.
const std::vector<const Language*>& languages();

/// @throw scan_cell_common::InvalidParameter if there is none of that name, naming all
const Language& language_named(const std::string& name);

/// By a file's ending; null where it is that of no language.
const Language* language_of(const std::string& file);

}  // namespace tool_path_programs
