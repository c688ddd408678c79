// SPDX-License-Identifier: MIT
// Values of M codes, outputs and inputs: from a machine file, and back to its text.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hal/machine/machine_value.hpp"
#include "motion/core/result.hpp"

namespace softcnc::hal {

// Each of these stores a value, or returns SC7004, SC7005, SC7006 or SC7027 with what the key
// takes; the caller puts the name of the key before the message.

/// Takes a number from `low` to `high`.
Status take_number(double& place, const FileValue& value, double low, double high);
/// Takes a whole number from `low` to `high`.
Status take_whole(int& place, const FileValue& value, int low, int high);
/// Takes the name of an output, or its number.
Status take_output_name(std::string& place, const FileValue& value);
/// Takes letters of words; those of codes and axes are refused.
Status take_letters(std::string& place, const FileValue& value);
/// Takes an array of numbers from `low` to `high`, of 10000 entries at most.
Status take_numbers(std::vector<double>& place, const FileValue& value, double low, double high);
/// X, Y and Z, mm.
Status take_point(AxisVector& place, const FileValue& value, double farthest);
/// Takes an array of numbers of lines, likewise.
Status take_lines(std::vector<double>& place, const FileValue& value);
/// Takes one of `words`; returns its index. An empty one cannot be given.
Result<std::size_t> take_index(const FileValue& value, std::span<const std::string_view> words);

/// Takes one of the words that name the values of an enumeration, in their order.
template <typename Choice>
Status take_word(Choice& place, const FileValue& value, std::span<const std::string_view> words) {
  return take_index(value, words).map([&](std::size_t index) {
    place = static_cast<Choice>(index);
  });
}

/// Returns a TOML basic string.
std::string quoted_text(std::string_view text);
/// Returns a TOML array.
std::string numbers_text(const std::vector<double>& numbers);
std::string point_text(const AxisVector& point);
template <typename Choice>
std::string word_text(Choice choice, std::span<const std::string_view> words) {
  return quoted_text(words[static_cast<std::size_t>(choice)]);
}

}  // namespace softcnc::hal
