// SPDX-License-Identifier: MIT
// Edits nearest to what was told are tried first; the one that leaves the fewest errors counts.
#include "ipr/repairs.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

namespace softcnc::ipr {
namespace {

constexpr int kMostMistakes = 8;             // lines that are mended
constexpr std::int64_t kMostWork = 1000000;  // lines read, and
constexpr std::int64_t kWorkOfTrial = 100;   // so many for each trial
constexpr int kMostExecuted = 20000;         // lines of one trial
constexpr std::size_t kLongestLine = 200;    // bytes of one that is mended

/// What may stand in a word, a variable or a label: nothing that begins a comment, ends a program
/// or leaves out a line.
constexpr std::string_view kTried = "0123456789.-GMXYZIJKRPFSQLTHDNOAEUW#[]=<> ";

using Place = std::tuple<int, int, int, Code>;  // file, line, column
using Places = std::multiset<Place>;

Place place_of(const Diagnostic& error) {
  return {error.pos.file, error.pos.line, error.pos.column, error.code};
}

int line_of(const Place& place) { return std::get<1>(place); }
bool is_on(const Place& place, int line) {
  return std::get<0>(place) == 0 && line_of(place) == line;
}

/// Where a line of the text begins and ends; nothing if there is none.
struct Range {
  std::size_t begin = 0, end = 0;
};

std::optional<Range> range_of(std::string_view text, int line) {
  Range range;
  for (int at = 1;; ++at) {
    range.end = std::min(text.find_first_of("\r\n", range.begin), text.size());
    if (at == line) return range;
    if (range.end == text.size()) return std::nullopt;
    const bool both = text.substr(range.end, 2) == "\r\n";
    range.begin = range.end + (both ? 2 : 1);
  }
}

/// Nothing but blanks and a '%' stands there.
bool is_rest_empty(std::string_view rest) {
  return rest.find_first_not_of(" \t\r\n%") == std::string_view::npos;
}

/// What is wrong with a text, and the line that ends it.
struct Found {
  Places places;
  int end = 0;
};

struct Mended {
  std::string text;
  Places left;  // what is wrong with it
};

class Repairs {
 public:
  Repairs(std::string text, Machine&& machine, InterpreterOptions&& options,
          const MachineState& state)
      : text_(std::move(text)),
        machine_(std::move(machine)),
        options_(std::move(options)),
        state_(state) {
    machine_.program.block_limit = std::min(machine_.program.block_limit, kMostExecuted);
    options_.compare_dialects = false;
    options_.refused_moves = nullptr;
  }

  Found read(const std::string& text) {
    Diagnostics diagnostics;
    Reader reader = Reader::from_text(text);
    Parser parser(reader, diagnostics);
    Interpreter interpreter(parser, machine_, diagnostics, options_, state_);
    Found found;
    std::int64_t blocks = 0;
    for (; const auto block = interpreter.next(); ++blocks) found.end = block->source.line;
    work_ += kWorkOfTrial + parser.lines_read() + blocks;
    for (const Diagnostic& d : diagnostics.all())
      if (d.severity() == Severity::error) found.places.insert(place_of(d));
    return found;
  }
  /// What is wrong with the text as it is.
  Places read() { return read(text_).places; }

  /// The text with a line mended that has errors, one at `column`, and what is wrong then. Nothing:
  /// no edit mends it.
  std::optional<Mended> mend(int line, int column, const Places& wrong) {
    const auto range = range_of(text_, line);
    if (!range || range->end - range->begin > kLongestLine) return std::nullopt;
    const std::string before = text_.substr(range->begin, range->end - range->begin);
    const bool last = is_rest_empty(std::string_view(text_).substr(range->end));
    std::optional<Mended> best;
    const auto attempt = [&](const std::string& edited) {
      if (work_ > kMostWork || (best && best->left.empty())) return;
      if (edited == before) return;
      std::string text = text_;
      text.replace(range->begin, before.size(), edited);
      auto [left, end] = read(text);
      const bool mends = (end != line || last) &&
                         std::none_of(left.begin(), left.end(),
                                      [&](const Place& place) { return is_on(place, line); });
      if (mends && (!best || left.size() < best->left.size()) &&
          std::includes(wrong.begin(), wrong.end(), left.begin(), left.end()))
        best = Mended{std::move(text), std::move(left)};
    };
    for_each_edit(before, static_cast<std::size_t>(std::max(column - 1, 0)), attempt);
    return best;
  }

  void go_on_with(std::string text) { text_ = std::move(text); }

 private:
  /// Edits of a line, those near a byte of it first.
  template <typename Attempt>
  static void for_each_edit(const std::string& line, std::size_t near, Attempt attempt) {
    std::vector<std::size_t> at(line.size() + 1);
    for (std::size_t i = 0; i < at.size(); ++i) at[i] = i;
    const auto distance = [&](std::size_t i) { return i > near ? i - near : near - i; };
    std::stable_sort(at.begin(), at.end(),
                     [&](std::size_t a, std::size_t b) { return distance(a) < distance(b); });
    for (const std::size_t i : at) {
      if (i < line.size()) attempt(std::string(line).erase(i, 1));
      if (i + 1 < line.size()) {
        std::string exchanged = line;
        std::swap(exchanged[i], exchanged[i + 1]);
        attempt(exchanged);
      }
      for (const char c : kTried) {
        if (i < line.size()) attempt(std::string(line).replace(i, 1, 1, c));
        attempt(std::string(line).insert(i, 1, c));
      }
    }
  }

  std::string text_;
  Machine machine_;
  InterpreterOptions options_;
  const MachineState& state_;
  std::int64_t work_ = 0;
};

}  // namespace

std::vector<bool> follow_from_others(std::string text, std::span<const Diagnostic> errors,
                                     Machine machine, InterpreterOptions options,
                                     const MachineState& state) {
  std::vector<bool> follows(errors.size(), false);
  Repairs repairs(std::move(text), std::move(machine), std::move(options), state);
  Places wrong = repairs.read();
  std::set<int> mended;  // lines
  const auto mark = [&](int line, const Places& left) {
    bool first = true;  // of the line, which is what is told of it
    for (std::size_t i = 0; i < errors.size(); ++i) {
      const Place place = place_of(errors[i]);
      if (!wrong.contains(place) || left.contains(place)) continue;
      const bool told = is_on(place, line) && std::exchange(first, false);
      if (!told) follows[i] = true;
    }
  };
  for (int mistakes = 0; mistakes < kMostMistakes; ++mistakes) {
    std::optional<Mended> best;
    int line_of_best = 0;
    std::set<int> tried;
    for (std::size_t i = 0; i < errors.size() && tried.size() < kMostMistakes; ++i) {
      const Place place = place_of(errors[i]);
      const int line = line_of(place);
      if (follows[i] || errors[i].pos.file != 0 || !wrong.contains(place)) continue;
      if (errors[i].code == Code::SC2310) continue;  // mended, the loop would not be run
      if (mended.contains(line) || !tried.insert(line).second) continue;
      auto one = repairs.mend(line, errors[i].pos.column, wrong);
      if (!one || (best && best->left.size() <= one->left.size())) continue;
      best = std::move(one);
      line_of_best = line;
    }
    if (!best) break;
    mark(line_of_best, best->left);
    mended.insert(line_of_best);
    wrong = std::move(best->left);
    repairs.go_on_with(std::move(best->text));
  }
  return follows;
}

}  // namespace softcnc::ipr
