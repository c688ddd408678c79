// SPDX-License-Identifier: MIT
#include "serve/grbl_numbers.hpp"

#include <algorithm>
#include <utility>

namespace softcnc::app {
namespace {

struct Row {
  Code first, last;
  int error;
};

/// The first row that contains a code counts.
constexpr Row kRows[] = {
    {Code::SC1001, Code::SC1001, 1},  // a word begins with a letter
    {Code::SC1015, Code::SC1015, 11}, {Code::SC1002, Code::SC1030, 2},  // numbers and expressions
    {Code::SC2002, Code::SC2002, 21}, {Code::SC2003, Code::SC2003, 25},
    {Code::SC2004, Code::SC2004, 36}, {Code::SC2005, Code::SC2005, 28},
    {Code::SC2101, Code::SC2101, 31}, {Code::SC2102, Code::SC2102, 22},
    {Code::SC2103, Code::SC2104, 33}, {Code::SC2107, Code::SC2107, 35},
    {Code::SC2108, Code::SC2109, 34}, {Code::SC2110, Code::SC2110, 24},
    {Code::SC2111, Code::SC2111, 30}, {Code::SC4001, Code::SC4001, 15},
    {Code::SC5070, Code::SC5072, 9},  {Code::SC5080, Code::SC5080, 8},
};

void replace_all(std::string& text, std::string_view word, std::string_view by) {
  for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + by.size()))
    text.replace(at, word.size(), by);
}

}  // namespace

int grbl_error(const Diagnostic& diagnostic) noexcept {
  for (const Row& row : kRows)
    if (diagnostic.code >= row.first && diagnostic.code <= row.last) return row.error;
  return GrblError::kUnsupported;
}

std::string grbl_message(const Diagnostic& diagnostic) {
  const Diagnostic found = shown(diagnostic);
  std::string text = std::string(code_name(found.code)) + ' ' + found.message;
  std::replace(text.begin(), text.end(), '[', '(');
  std::replace(text.begin(), text.end(), ']', ')');
  for (const auto& [word, by] : {std::pair{"error", "fault"}, {"Error", "Fault"}, {"ok", "o-k"}})
    replace_all(text, word, by);
  for (char& c : text)
    if (c < ' ' || c > '~') c = '?';
  return "[MSG:" + text + "]";
}

}  // namespace softcnc::app
