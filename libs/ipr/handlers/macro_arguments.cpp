// SPDX-License-Identifier: MIT
// FANUC's two lists of arguments, in one pass: only I, J and K differ between them.
#include "ipr/handlers/macro_arguments.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

#include "ipr/expressions/parameters.hpp"

namespace softcnc::ipr {
namespace {

/// The letter at index n - 1 belongs to #n.
constexpr std::string_view kLetters = "ABCIJKDEF.H.M...QRSTUVWXYZ";
static_assert(kLetters.size() == 26);

/// Numbers the words, in their order. Of those with one number the last counts, as on FANUC's
/// controls.
class Numbering {
 public:
  /// 0: a letter that is no argument.
  int number(char letter) {
    const auto at = std::string_view("IJK").find(letter);
    if (at != std::string_view::npos) return set_number(static_cast<int>(at));
    const auto plain = kLetters.find(letter);
    return plain == std::string_view::npos ? 0 : static_cast<int>(plain) + 1;
  }

 private:
  /// A letter that does not follow the one before in the alphabet begins the next set of three.
  int set_number(int index) {
    if (index <= last_) ++set_;
    last_ = index;
    return 4 + 3 * set_ + index;
  }

  int set_ = 0, last_ = -1;
};

/// Those that could not be read: of I, J and K nobody knows which set of three they belong to.
void lose_unread(std::vector<double>& values, LetterSet unread, int locals) {
  if (unread.empty()) return;
  values.resize(static_cast<std::size_t>(locals), kVacant);
  for (double& value : values)
    if (is_vacant(value)) value = kUnknown;
  constexpr std::ptrdiff_t kFirstSet = 3;
  if (unread.has_any("IJK")) std::fill(values.begin() + kFirstSet, values.end(), kUnknown);
}

}  // namespace

std::optional<std::vector<double>> macro_arguments(Task& task) {
  const Parameters& parameters = task.flow.parameters();
  std::vector<double> values;
  Numbering numbering;
  bool good = true;
  for (const Word& word : task.command.arguments()) {
    if (word.letter == 'P' || word.letter == 'L') continue;
    const int number = numbering.number(word.letter);
    if (number == 0 || number > parameters.locals()) {
      task.out.report(Code::SC2311, word.pos,
                      number == 0
                          ? std::string(1, word.letter) + " is no argument of G65"
                          : "one argument too many: there is no local #" + std::to_string(number));
      good = false;
      if (number == 0) continue;
      break;  // so are those after it
    }
    const auto index = static_cast<std::size_t>(number) - 1;
    if (index >= values.size()) values.resize(index + 1, kVacant);
    values[index] = word.value;
  }
  if (!good) return std::nullopt;
  lose_unread(values, task.command.unread(), parameters.locals());
  return values;
}

}  // namespace softcnc::ipr
