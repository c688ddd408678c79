// SPDX-License-Identifier: MIT
#include "ipr/commands/command_line.hpp"

#include <algorithm>
#include <utility>

#include "ipr/text/lexer.hpp"

namespace softcnc::ipr {
namespace {

constexpr bool is_separator(char c) noexcept { return is_blank(c) || c == ','; }

constexpr char lower(char c) noexcept {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}
/// How many of the first characters are of one kind.
template <typename Is>
std::size_t run_of(std::string_view text, Is&& is) {
  return static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), is) - text.begin());
}

}  // namespace

CommandField CommandLine::next() {
  for (; at_ < line_.size() && line_[at_] != ';'; ++at_) {
    const char c = line_[at_];
    if (is_separator(c)) continue;
    if (is_letter(c)) return read_name();
    if (is_number_part(c)) return read_number_field();
    if (c != '(' || !pass_comment()) return read_error();
  }
  at_ = line_.size();
  return field(CommandField::Kind::end, 0);
}

/// Goes on to the ')' of the comment at at_; false if there is none.
bool CommandLine::pass_comment() noexcept {
  const std::size_t close = line_.find(')', at_);
  if (close == std::string_view::npos) return false;
  at_ = close;
  return true;
}

CommandField CommandLine::field(CommandField::Kind kind, std::size_t length) noexcept {
  CommandField field;
  field.kind = kind;
  field.column = static_cast<int>(at_) + 1;
  field.length = static_cast<int>(length);
  at_ += length;
  return field;
}

CommandField CommandLine::faulty(std::size_t length, TextError error) {
  CommandField faulty = field(CommandField::Kind::error, length);
  faulty.error = std::move(error);
  return faulty;
}

CommandField CommandLine::faulty_number(std::size_t length, TextError error) {
  CommandField number = faulty(length, std::move(error));
  number.stands_for_number = true;
  return number;
}

CommandField CommandLine::read_name() {
  const std::string_view rest = line_.substr(at_);
  CommandField name = field(CommandField::Kind::name, run_of(rest, is_letter));
  name.name = rest.substr(0, static_cast<std::size_t>(name.length));
  std::transform(name.name.begin(), name.name.end(), name.name.begin(), lower);
  return name;
}

CommandField CommandLine::read_number_field() {
  const std::string_view rest = line_.substr(at_);
  const std::string_view written = rest.substr(0, run_of(rest, is_number_part));
  if (written.size() < rest.size() && lower(rest[written.size()]) == 'e') {
    const std::size_t exponent = run_of(rest.substr(written.size() + 1), is_number_part);
    const std::string_view whole = rest.substr(0, written.size() + 1 + exponent);
    return faulty_number(
        whole.size(), {Code::SC1006, in_quotes(whole) + " has an exponent; write the number out"});
  }
  const Number number = read_number(written);
  if (number.error != NumberError::none)
    return faulty_number(written.size(), number_error(number.error, written, "the command"));
  CommandField read = field(CommandField::Kind::number, written.size());
  read.value = number.value;
  return read;
}

CommandField CommandLine::read_error() {
  const std::string_view rest = line_.substr(at_);
  if (rest.front() == '(') return faulty(rest.size(), {Code::SC1009, "the comment has no ')'"});
  if (rest.front() == '\0')
    return faulty(1, {Code::SC1014, "a byte 0; the file is damaged or no text"});
  const std::string_view character = rest.substr(0, character_length(rest));
  return faulty(character.size(), {Code::SC1001, "unknown character " + character_name(character)});
}

}  // namespace softcnc::ipr
