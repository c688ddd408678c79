// SPDX-License-Identifier: MIT
// Finds the known name that resembles an unknown one.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace softcnc {

/// Returns how much two names differ whose words are separated by '.', '_' and '-', regardless of
/// case: 0 if they are equal; 1 for each word that has nothing in common with the one in its place.
/// Equal words count more than letters, and a common beginning more than other letters; a word that
/// `asked` omits counts least, such as a unit or a section. How words are separated matters little.
double words_apart(std::string_view asked, std::string_view known);

/// Whether names this far apart resemble each other: they differ by less than half.
bool is_like(std::string_view asked, double apart);

/// Returns the first of those that resemble `asked` most; empty if none does.
std::string nearest_name(std::string_view asked, std::span<const std::string_view> known);

/// Returns "; did you mean 'NAME'?", or empty without a name.
std::string did_you_mean(std::string_view name);

}  // namespace softcnc
