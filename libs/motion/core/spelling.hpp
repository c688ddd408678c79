// SPDX-License-Identifier: MIT
// Which of the names that there are is like one that there is not.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace softcnc {

/// How unlike two names are whose words are parted by '.', '_' and '-', whatever the case of their
/// letters: 0 if they are equal; 1 for each word that has nothing in common with the one in its
/// place. Equal words weigh before letters, and a common beginning before other letters; a word
/// that `asked` leaves out counts least, as a unit or a section. How words are parted
/// matters little.
double words_apart(std::string_view asked, std::string_view known);

/// Whether names so far apart are like each other: they differ by less than half.
bool is_like(std::string_view asked, double apart);

/// The first of those that are most like `asked`; empty if none is like it.
std::string nearest_name(std::string_view asked, std::span<const std::string_view> known);

/// "; did you mean 'NAME'?", or empty without a name.
std::string did_you_mean(std::string_view name);

}  // namespace softcnc
