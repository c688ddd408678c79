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
#include <vector>

#include "ipr/expressions/dialect.hpp"

namespace softcnc::ipr {

/// What a variable holds that has no value: #0 of FANUC. A word with it counts as not written.
inline constexpr double kVacant = std::numeric_limits<double>::quiet_NaN();
/// What a variable holds whose value an error has made unknown: what rests on it is not reported.
inline constexpr double kUnknown = std::numeric_limits<double>::infinity();
inline bool is_vacant(double value) noexcept { return std::isnan(value); }
inline bool is_unknown(double value) noexcept { return std::isinf(value); }

/// The variables that stand for the state of the machine. Lengths are in the units of the program.
class SystemVariables {
 public:
  virtual ~SystemVariables() = default;

  /// Nothing: no variable of the system has this number or name (lower case, without blanks).
  virtual std::optional<double> read(int number) const = 0;
  /// Whether there is one of this number in a dialect.
  virtual bool has(int number, Dialect dialect) const = 0;
  virtual std::optional<double> read(std::string_view name) const = 0;
  virtual bool is_read_only(int number) const = 0;
  /// How far from 0 an assigned value may lie.
  virtual double limit(int number) const = 0;
  /// Mm in the unit in which the fanuc dialect counts what linuxcnc counts in mm; otherwise 1.
  virtual double fanuc_unit(int number) const = 0;
  /// False: no variable of the system has this number. Expects one that may be written.
  virtual bool write(int number, double value) = 0;
  /// Remembers the value of an ordinary variable for the next program.
  virtual void keep(int number, double value) = 0;
};

class Parameters {
 public:
  enum class Access : std::uint8_t { granted, no_such, read_only };

  explicit Parameters(Dialect dialect = Dialect::linuxcnc);

  Dialect dialect() const noexcept { return dialect_; }
  /// Must outlive its use here; nullptr: the system has no variables.
  void set_system(SystemVariables* system) noexcept { system_ = system; }
  /// Ordinary variables with what an earlier program has left in them: what is assigned to them is
  /// kept by the system. Others, and those local to a call, are passed over.
  void keep(const std::map<int, double>& values);

  /// Nothing: there is no such variable, or, of a name, none has been assigned.
  std::optional<double> read(int number) const;
  /// Names are in lower case and without blanks; those that begin with '_' are global.
  std::optional<double> read(std::string_view name) const;
  bool exists(int number) const { return read(number).has_value(); }
  bool exists(std::string_view name) const { return read(name).has_value(); }

  /// What the other dialect would read. Expects one that is not of FANUC's system alone.
  std::optional<double> read_as(int number, Dialect other) const;
  /// Whether it is the system's in the fanuc dialect, and a variable like others in linuxcnc.
  bool is_fanuc_system(int number) const;
  /// As of SystemVariables.
  double fanuc_unit(int number) const;
  /// Whether it is local in the fanuc dialect alone.
  static bool is_fanuc_local(int number) noexcept;

  /// Whether expressions are to be compared with what they mean in the other dialect.
  void watch() noexcept { watching_ = true; }
  bool watching() const noexcept { return watching_; }

  /// Whether an assignment is possible.
  Access access(int number) const;
  Access access(std::string_view name) const;
  /// How far from 0 a value may lie that is assigned.
  double limit(int number) const;
  /// Expects that access is granted, and a value within the limit.
  void write(int number, double value);
  void write(std::string_view name, double value);

  /// An assignment has been lost by an error, and with it, whose it was.
  void lose() noexcept { lost_ = true; }
  /// An assignment to this one of the system has been refused: what the program would go on with is
  /// not known.
  void lose(int number) { refused_.insert(number); }
  void lose(std::string_view name) { write(name, kUnknown); }
  /// So have been all that a subprogram might have done; `locals`: to those of its caller too.
  void lose_all(bool locals);
  /// A probing move has been refused: where it would have ended, #5061 to #5070, is not known.
  void lose_probed_point();

  /// Begins a level of calls: local variables of its own, the arguments in #1 and up.
  void push(std::span<const double> arguments);
  /// Ends it. Expects a level above 0.
  void pop();
  int level() const noexcept { return static_cast<int>(levels_.size()) - 1; }
  /// What the last subprogram has given back, for #<_value> and #<_value_returned>.
  void give_back(std::optional<double> value) noexcept { given_back_ = value; }
  /// Number of the line that is read, for #<_line>.
  void set_line(int line) noexcept { line_ = line; }
  /// How many numbered variables are local to a level: #1 and up.
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
  std::vector<Level> levels_;
  Names global_;
  std::optional<double> given_back_;
  int line_ = 0;
  bool lost_ = false, probed_point_lost_ = false, watching_ = false;
};

}  // namespace softcnc::ipr
