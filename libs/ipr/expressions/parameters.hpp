// SPDX-License-Identifier: MIT
// The '#' variables of a program: numbered, named, local to a call, and those of the system.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ipr/expressions/dialect.hpp"

namespace softcnc::ipr {

/// The value of a variable without a value, as #0 of FANUC. A word with it counts as not written.
inline constexpr double kVacant = std::numeric_limits<double>::quiet_NaN();
/// The value of a variable that an error has made unknown: what depends on it is not reported.
inline constexpr double kUnknown = std::numeric_limits<double>::infinity();
inline bool is_vacant(double value) noexcept { return std::isnan(value); }
inline bool is_unknown(double value) noexcept { return std::isinf(value); }

/// The variables that stand for the state of the machine. Lengths are in the units of the program.
class SystemVariables {
 public:
  virtual ~SystemVariables() = default;

  /// Returns the value of a variable; nothing if the system has none of this number or name (lower
  /// case, without blanks).
  virtual std::optional<double> read(int number) const = 0;
  /// Returns whether the system has a variable of this number in a dialect.
  virtual bool has(int number, Dialect dialect) const = 0;
  virtual std::optional<double> read(std::string_view name) const = 0;
  virtual bool is_read_only(int number) const = 0;
  /// Returns how far from 0 an assigned value may lie.
  virtual double limit(int number) const = 0;
  /// Returns whether the unit of the variable has to be assumed, since nothing states it; at most
  /// once in a program.
  virtual bool assumes_unit(int /*number*/) const { return false; }
  /// Returns the unit, in mm, in which the fanuc dialect counts what linuxcnc counts in mm; 1 for
  /// all other variables.
  virtual double fanuc_unit(int number) const = 0;
  /// Assigns a value. Returns false if the system has no variable of this number. Requires one that
  /// may be written.
  virtual bool write(int number, double value) = 0;
  /// Remembers the value of an ordinary variable for the next program.
  virtual void keep(int number, double value) = 0;
  /// Does the same for a global variable with a name.
  virtual void keep(std::string_view name, double value) = 0;
};

class Parameters {
 public:
  enum class Access : std::uint8_t { granted, no_such, read_only };

  explicit Parameters(Dialect dialect = Dialect::linuxcnc);

  Dialect dialect() const noexcept { return dialect_; }
  /// Sets the variables of the system, which must outlive these parameters; nullptr if there are
  /// none.
  void set_system(SystemVariables* system) noexcept { system_ = system; }
  /// Sets ordinary variables to what an earlier program has left in them, and makes the system keep
  /// what is assigned to them. Others, and those local to a call, are skipped.
  void keep(const std::map<int, double>& values);
  /// Does the same for global variables with names (as read() takes them).
  void keep(const std::map<std::string, double>& values);
  /// Sets a variable before the first line: a global one by its name, or an ordinary one by its
  /// number in digits. Returns false, and sets nothing, for those of the system and those local to
  /// a call.
  bool define(std::string_view name, double value);

  /// Returns the value of a variable; nothing if there is no such variable, or none of this name
  /// has been assigned.
  std::optional<double> read(int number) const;
  /// Returns the same by name. Names are in lower case and without blanks; those that begin with
  /// '_' are global.
  std::optional<double> read(std::string_view name) const;
  bool exists(int number) const { return read(number).has_value(); }
  bool exists(std::string_view name) const { return read(name).has_value(); }

  /// Returns what the other dialect would read. Requires a variable that does not belong to FANUC's
  /// system alone.
  std::optional<double> read_as(int number, Dialect other) const;
  /// Returns whether the variable belongs to the system in the fanuc dialect, and is one like
  /// others in linuxcnc.
  bool is_fanuc_system(int number) const;
  /// Returns what SystemVariables::fanuc_unit() returns; 1 if there is no system.
  double fanuc_unit(int number) const;
  /// Returns whether the variable is local in the fanuc dialect alone.
  static bool is_fanuc_local(int number) noexcept;

  /// Makes expressions compare what they mean in both dialects; watching() returns whether they do.
  void watch() noexcept { watching_ = true; }
  bool watching() const noexcept { return watching_; }

  /// Returns whether an assignment is possible.
  Access access(int number) const;
  Access access(std::string_view name) const;
  /// Returns how far from 0 an assigned value may lie.
  double limit(int number) const;
  /// Returns the variable whose unit has been assumed since the last call; 0 if there is none.
  int take_assumed() noexcept { return std::exchange(assumed_, 0); }
  /// Assigns a value. Requires that access is granted, and a value within the limit.
  void write(int number, double value);
  void write(std::string_view name, double value);

  /// Records that an error has lost an assignment, and to which variable: from then on a name that
  /// has not been assigned is kUnknown.
  void lose() noexcept { lost_ = true; }
  /// Records that an assignment to this variable of the system has been refused: the value with
  /// which the program would continue is unknown.
  void lose(int number) { refused_.insert(number); }
  void lose(std::string_view name) { write(name, kUnknown); }
  /// Makes unknown whatever a subprogram might have assigned; with `locals`, the local variables of
  /// its caller too.
  void lose_all(bool locals);
  /// Records that a probing move has an error: #5061 to #5070, where it would have ended, are
  /// unknown.
  void lose_probed_point();
  /// Sets #5061 to #5063 to where a probing move has ended, and in dialects like that of LinuxCNC
  /// #5070 to whether it came to a contact.
  void keep_probed_point(const std::array<double, 3>& place, bool contact);

  /// Begins a level of calls with local variables of its own; the arguments are its #1 and up.
  void push(std::span<const double> arguments);
  /// Ends a level of calls. Requires a level above 0.
  void pop();
  int level() const noexcept { return static_cast<int>(levels_.size()) - 1; }
  /// Sets what the last subprogram has returned, for #<_value> and #<_value_returned>.
  void give_back(std::optional<double> value) noexcept { given_back_ = value; }
  /// Sets the number of the line that is read, for #<_line>.
  void set_line(int line) noexcept { line_ = line; }
  /// Begins a pass of the program, for may_differ().
  void begin_pass() noexcept { may_differ_ = false; }
  /// Returns whether variables may have other values in the next pass of the program than in this
  /// one: one has been assigned, or one of the system read.
  bool may_differ() const noexcept { return may_differ_; }
  /// Returns how many numbered variables are local to a level, from #1 on.
  int locals() const noexcept { return locals_; }

 private:
  using Names = std::map<std::string, double, std::less<>>;
  struct Level {
    std::array<double, 34> numbered{};
    Names named;
  };

  std::optional<double> own(std::string_view name) const noexcept;
  bool is_system(int number) const noexcept { return number >= first_system_; }
  bool is_ordinary(int number) const noexcept;
  bool is_kept(int number) const noexcept { return is_system(number) && is_ordinary(number); }
  bool is_lost(int number) const;
  double probed_value(int number) const noexcept;
  double stored(int number) const noexcept;
  void store(int number, double value);
  void write_ordinary(int number, double value);
  const Names& names_of(std::string_view name) const noexcept;

  Dialect dialect_;
  int locals_, first_system_;
  SystemVariables* system_ = nullptr;
  std::vector<double> numbered_;  // by number, unset_ after the last; local ones lie in levels_
  double unset_ = kVacant;
  std::set<int> kept_, refused_;
  std::set<int> known_again_;  // of those that the system keeps, after all were lost
  std::set<std::string, std::less<>> kept_names_;
  std::vector<Level> levels_;
  Names global_;
  std::optional<double> given_back_;
  int line_ = 0;
  std::optional<std::array<double, 3>> probed_point_;  // of fanuc and haas: #5061 to #5063
  bool lost_ = false, probed_point_lost_ = false, watching_ = false, kept_lost_ = false;
  mutable bool may_differ_ = false;  // reading a variable of the system sets it too
  mutable int assumed_ = 0;
};

}  // namespace softcnc::ipr
