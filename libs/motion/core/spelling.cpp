// SPDX-License-Identifier: MIT
#include "motion/core/spelling.hpp"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace softcnc {
namespace {

constexpr double kAbbreviated = 0.2;  // a word that is the beginning of the other one
constexpr double kLeftOut = 0.1;      // a word that only the known name has
constexpr double kTooMany = 0.7;      // a word that only the asked one has
constexpr double kLike = 0.4;         // of the words asked

std::vector<std::string> words_of(std::string_view name) {
  constexpr std::string_view kBetween = "._-";
  std::vector<std::string> words(1);
  for (const char c : name) {
    const bool upper = c >= 'A' && c <= 'Z';
    if (kBetween.find(c) == kBetween.npos)
      words.back() += upper ? static_cast<char>(c - 'A' + 'a') : c;
    else if (!words.back().empty())
      words.emplace_back();
  }
  return words;
}

/// Returns how many letters must be changed, added, left out or swapped with the next (optimal
/// string alignment).
std::size_t letters_apart(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before, last(b.size() + 1), row(b.size() + 1);
  std::iota(last.begin(), last.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({replaced, last[j] + 1, row[j - 1] + 1});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before = std::exchange(last, row);
  }
  return last[b.size()];
}

double word_apart(std::string_view a, std::string_view b) {
  if (a == b) return 0;
  const std::size_t shorter = std::min(a.size(), b.size()), longer = std::max(a.size(), b.size());
  if (shorter == 0) return 1;
  const auto common = static_cast<std::size_t>(
      std::mismatch(a.begin(), a.begin() + static_cast<std::ptrdiff_t>(shorter), b.begin()).first -
      a.begin());
  const double letters = static_cast<double>(letters_apart(a, b)) / static_cast<double>(longer);
  if (common < 2) return letters;
  const double begins = static_cast<double>(common) / static_cast<double>(shorter);
  return std::min(letters, 1 - (1 - kAbbreviated) * begins);
}

std::string joined(const std::vector<std::string>& words) {
  std::string all;
  for (const std::string& word : words) all += word;
  return all;
}

/// Compares the letters, however they are separated into words.
double joined_apart(const std::vector<std::string>& a, const std::vector<std::string>& b) {
  const std::string one = joined(a), other = joined(b);
  const auto longer = static_cast<double>(std::max({one.size(), other.size(), std::size_t{1}}));
  return static_cast<double>(a.size() * letters_apart(one, other)) / longer;
}

double words_apart(const std::vector<std::string>& a, const std::vector<std::string>& b) {
  std::vector<double> row(b.size() + 1);
  for (std::size_t j = 0; j < row.size(); ++j) row[j] = kLeftOut * static_cast<double>(j);
  for (const std::string& word : a) {
    double diagonal = std::exchange(row[0], row[0] + kTooMany);
    for (std::size_t j = 1; j < row.size(); ++j) {
      const double replaced = diagonal + word_apart(word, b[j - 1]);
      diagonal = row[j];
      row[j] = std::min({replaced, row[j] + kTooMany, row[j - 1] + kLeftOut});
    }
  }
  return row.back();
}

}  // namespace

double words_apart(std::string_view asked, std::string_view known) {
  const auto a = words_of(asked), b = words_of(known);
  return std::min(words_apart(a, b), joined_apart(a, b));
}

bool is_like(std::string_view asked, double apart) {
  constexpr double kRounding = 1e-9;
  return apart <= kLike * static_cast<double>(words_of(asked).size()) + kRounding;
}

std::string nearest_name(std::string_view asked, std::span<const std::string_view> known) {
  const std::string_view* nearest = nullptr;
  double least = 0;
  for (const std::string_view& name : known) {
    const double apart = words_apart(asked, name);
    if (nearest != nullptr && apart >= least) continue;
    nearest = &name;
    least = apart;
  }
  return nearest != nullptr && is_like(asked, least) ? std::string(*nearest) : std::string();
}

std::string did_you_mean(std::string_view name) {
  return name.empty() ? std::string() : "; did you mean '" + std::string(name) + "'?";
}

}  // namespace softcnc
