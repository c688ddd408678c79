// SPDX-License-Identifier: MIT
#include "hal/machine/device_value.hpp"

#include <cmath>
#include <cstdint>
#include <variant>

#include "hal/files/number.hpp"
#include "motion/core/spelling.hpp"

namespace softcnc::hal {
namespace {

constexpr std::size_t kMostNumbers = 10'000;  // of the table of an input

}  // namespace

Status take_number(double& place, const FileValue& value, double low, double high) {
  double given = 0;
  if (const auto* real = std::get_if<double>(&value))
    given = *real;
  else if (const auto* whole = std::get_if<std::int64_t>(&value))
    given = static_cast<double>(*whole);
  else
    return value_failure(Code::SC7004, "takes a number");
  if (!(given >= low && given <= high))
    return value_failure(Code::SC7005, "must be at least " + number_text(low) + " and at most " +
                                           number_text(high) + ", not " + number_text(given));
  place = given + 0.0;
  return {};
}

Status take_whole(int& place, const FileValue& value, int low, int high) {
  if (!std::holds_alternative<std::int64_t>(value))
    return value_failure(Code::SC7004, "takes an integer");
  double number = 0;
  auto taken = take_number(number, value, low, high);
  if (taken) place = static_cast<int>(number);
  return taken;
}

Result<std::size_t> take_index(const FileValue& value, std::span<const std::string_view> words) {
  const auto fail = [](Code code, std::string message) {
    return tl::make_unexpected(Diagnostic{.code = code, .message = std::move(message)});
  };
  const auto* word = std::get_if<std::string>(&value);
  if (word == nullptr) return fail(Code::SC7004, "takes one of " + quoted_words(words));
  const auto found = std::find(words.begin(), words.end(), *word);
  if (found == words.end() || word->empty())
    return fail(Code::SC7006, "must be one of " + quoted_words(words) + ", not '" + *word + "'" +
                                  did_you_mean(nearest_name(*word, words)));
  return static_cast<std::size_t>(found - words.begin());
}

Status take_output_name(std::string& place, const FileValue& value) {
  if (const auto* text = std::get_if<std::string>(&value))
    place = *text;
  else if (const auto* number = std::get_if<std::int64_t>(&value))
    place = std::to_string(*number);
  else
    return value_failure(Code::SC7004, "takes the name of an output or its number");
  return {};
}

Status take_letters(std::string& place, const FileValue& value) {
  constexpr std::string_view kTaken = "FGMNOSTXYZ";
  const auto* text = std::get_if<std::string>(&value);
  if (text == nullptr) return value_failure(Code::SC7004, "takes a string of letters");
  std::string letters;
  for (const char c : *text) {
    const char letter = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    if (letter < 'A' || letter > 'Z' || kTaken.find(letter) != kTaken.npos)
      return value_failure(Code::SC7027,
                           "takes letters other than F G M N O S T X Y Z, not '" + *text + "'");
    if (letters.find(letter) == letters.npos) letters += letter;
  }
  place = letters;
  return {};
}

Status take_numbers(std::vector<double>& place, const FileValue& value, double low, double high) {
  const auto* given = std::get_if<std::vector<double>>(&value);
  if (given == nullptr) return value_failure(Code::SC7004, "takes an array of numbers");
  if (given->size() > kMostNumbers)
    return value_failure(Code::SC7027,
                         "has more than " + std::to_string(kMostNumbers) + " entries");
  std::vector<double> numbers;
  for (const double number : *given)
    if (auto taken = take_number(numbers.emplace_back(), number, low, high); !taken) return taken;
  place = std::move(numbers);
  return {};
}

Status take_point(AxisVector& place, const FileValue& value, double farthest) {
  std::vector<double> numbers;
  if (auto taken = take_numbers(numbers, value, -farthest, farthest); !taken) return taken;
  if (numbers.size() != kAxes) return value_failure(Code::SC7027, "takes three numbers: [X, Y, Z]");
  place = {numbers[0], numbers[1], numbers[2]};
  return {};
}

Status take_lines(std::vector<double>& place, const FileValue& value) {
  constexpr double kLastLine = 1e9;
  std::vector<double> lines;
  if (auto taken = take_numbers(lines, value, 1, kLastLine); !taken) return taken;
  const auto is_whole = [](double line) { return line == std::floor(line); };
  if (!std::all_of(lines.begin(), lines.end(), is_whole))
    return value_failure(Code::SC7027, "takes the numbers of lines, which are whole");
  place = std::move(lines);
  return {};
}

std::string quoted_text(std::string_view text) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string out = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') out += '\\';
    if (byte >= 0x20 && byte != 0x7F)
      out += c;
    else
      out.append("\\u00").append(1, kDigits[byte >> 4U]).append(1, kDigits[byte & 15U]);
  }
  return out + '"';
}

std::string point_text(const AxisVector& point) {
  return numbers_text({point[0], point[1], point[2]});
}

std::string numbers_text(const std::vector<double>& numbers) {
  std::string text;
  for (const double number : numbers) text += (text.empty() ? "" : ", ") + number_text(number);
  return '[' + text + ']';
}

}  // namespace softcnc::hal
