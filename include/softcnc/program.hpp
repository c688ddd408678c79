// SPDX-License-Identifier: MIT
// A part program, and what is wrong with it on a machine.
#pragma once

#include <iosfwd>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <softcnc/constraint.hpp>
#include <softcnc/diagnostic.hpp>
#include <softcnc/export.hpp>
#include <softcnc/machine.hpp>
#include <softcnc/setpoint.hpp>
#include <softcnc/state.hpp>

namespace softcnc::api {

/// A program can be read any number of times.
class SOFTCNC_API Program {
 public:
  /// Opens a file; programs that it calls lie in the same folder. Errors: SC6001, SC6002.
  static Expected<Program> open(const std::string& file);
  /// Takes a text; `name` stands for the file in diagnostics. It can call no files. Errors: SC6003,
  /// where the text cannot be kept.
  static Expected<Program> from_text(const std::string& text, const std::string& name = "program");
  /// Does the same for all that a stream has.
  static Expected<Program> from_stream(std::istream& in, const std::string& name = "program");

  Program(Program&& other) noexcept;
  Program& operator=(Program&& other) noexcept;
  ~Program();

  const std::string& name() const noexcept;

  struct Data;
  Data& data() const noexcept { return *data_; }

 private:
  explicit Program(std::unique_ptr<Data> data) noexcept;
  std::unique_ptr<Data> data_;
};

/// Whose reading of G-code counts; automatic: by the text of the program, linuxcnc where that shows
/// none.
enum class Dialect : std::uint8_t { linuxcnc, fanuc, haas, grbl, automatic };

/// How a program is run.
struct RunOptions {
  double feed_override = 1;  // of the programmed feed, as it begins: 0.001 to 2
  Dialect dialect = Dialect::linuxcnc;
  bool block_skip = false;     // leave out lines that begin with '/'
  bool optional_stop = false;  // M01 stops
  /// Folders of called files, after that of the program and before `program.path` of the machine.
  std::vector<std::string> subprogram_folders;
  /// Variables that are set before the first line: "_td" is #<_td>, "100" is #100. A name that no
  /// program could assign to is reported when the program is read (SC2318).
  std::map<std::string, double> definitions;
  /// What earlier programs have left.
  State state;
  /// Where the machine stands, mm, in machine coordinates. Without it, and beyond 1000 m from zero
  /// or where it is no number, where the state says; machine zero, if that says nothing.
  std::optional<AxisVector> start = std::nullopt;
  /// Limits beyond those of the machine.
  std::vector<std::shared_ptr<const Constraint>> constraints;
};

/// Returns all that is wrong with a program on a machine, as `softcnc check` reports it: errors,
/// warnings and notes in the order in which they are found. The program is planned and verified to
/// its end; nothing moves.
SOFTCNC_API std::vector<Diagnostic> check(const Program& program, const Machine& machine,
                                          const RunOptions& options = {});

}  // namespace softcnc::api
