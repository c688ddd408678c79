// SPDX-License-Identifier: MIT
#include "ipr/lines/beyond_grbl.hpp"

#include <algorithm>
#include <cmath>

#include "ipr/codes/gcode.hpp"
#include "ipr/dialects/grbl_reading.hpp"
#include "ipr/text/number.hpp"

namespace softcnc::ipr {
namespace {

bool is_code(const Word& word) noexcept { return word.letter == 'G' || word.letter == 'M'; }

bool is_beyond(const Word& code) noexcept {
  return !is_grbl_code(code.letter, static_cast<int>(std::lround(code.value * 10)));
}

/// The L of a G10 that sets something else than a work system.
const Word* other_table(const ProgramLine& line) noexcept {
  const auto find = [&](auto is_it) -> const Word* {
    const auto found = std::find_if(line.words.begin(), line.words.end(), is_it);
    return found == line.words.end() ? nullptr : &*found;
  };
  if (!find([](const Word& word) { return word.letter == 'G' && word.value == 10; }))
    return nullptr;
  return find(
      [](const Word& word) { return word.letter == 'L' && word.value != 2 && word.value != 20; });
}

}  // namespace

void note_beyond_grbl(Output& out, SourcePos pos, const std::string& subject,
                      const std::string& what) {
  out.report_once(Code::SC1056, pos, subject, "grbl 1.1 refuses " + what);
}

void note_beyond_grbl(const ProgramLine& line, Output& out) {
  if (line.broken || out.failed()) return;
  bool beyond = false;
  for (const Word& word : line.words) {
    if (!is_code(word) || !is_beyond(word)) continue;
    const std::string name = code_name(word.letter, word.value);
    note_beyond_grbl(out, word.pos, name, name + ", which it does not have");
    beyond = true;
  }
  if (beyond) return;
  if (const Word* table = other_table(line)) {
    const std::string name = "G10 L" + number_text(table->value);
    note_beyond_grbl(out, table->pos, name, name + "; it has L2 and L20");
  }
  for (const Word& word : line.words)
    if (!is_grbl_letter(word.letter) && word.letter != 'O')
      note_beyond_grbl(out, word.pos, {word.letter},
                       std::string("the word ") + word.letter + ", which it does not have");
}

}  // namespace softcnc::ipr
