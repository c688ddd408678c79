// SPDX-License-Identifier: MIT
// A line of a command file (paper 003, Table 6) as fields: a name and numbers.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "ipr/text/text_errors.hpp"

namespace softcnc::ipr {

struct CommandField {
  enum class Kind : std::uint8_t { end, name, number, error };
  Kind kind = Kind::end;
  std::string name;                // in lower case
  double value = 0;                // of a number
  int column = 1;                  // of the first byte
  int length = 1;                  // bytes
  TextError error{};               // what is wrong here
  bool stands_for_number = false;  // what cannot be read is one
};

/// Splits a line into fields. Blanks and commas separate them; `;` and parentheses hold comments.
class CommandLine {
 public:
  explicit CommandLine(std::string_view line) noexcept : line_(line) {}

  /// Returns the next field. After the last one it returns Kind::end, however often it is called.
  CommandField next();

 private:
  bool pass_comment() noexcept;
  CommandField field(CommandField::Kind kind, std::size_t length) noexcept;
  CommandField read_name();
  CommandField read_number_field();
  CommandField read_error();
  CommandField faulty(std::size_t length, TextError error);
  CommandField faulty_number(std::size_t length, TextError error);

  std::string_view line_;
  std::size_t at_ = 0;
};

}  // namespace softcnc::ipr
