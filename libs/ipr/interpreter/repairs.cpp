// SPDX-License-Identifier: MIT
// Edits nearest to what was told are tried first; the one that leaves the fewest errors counts.
#include "ipr/interpreter/repairs.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

#include "ipr/text/number.hpp"

namespace softcnc::ipr {
namespace {

constexpr int kMostMistakes = 4;                // lines that are mended
constexpr std::size_t kMostLines = 8;           // lines that are tried, for each
constexpr std::int64_t kMostWork = 20'000'000;  // bytes read, and
constexpr std::int64_t kWorkOfTrial = 4'000;    // as much as so many for each trial
constexpr std::size_t kLongestLine = 200;       // bytes of one that is mended
constexpr int kBeside = 1;  // columns beside what is told, in which its cause may stand

/// What may stand in a word, a variable or a label: nothing that begins a comment, ends a program
/// or leaves out a line.
constexpr std::string_view kTried = "0123456789.-GMXYZIJKRPFSQLTHDNOAEUW#[]=<> ";

using Place = std::tuple<int, int, int, Code>;  // file, line, column
using Places = std::multiset<Place>;

Place place_of(const Diagnostic& error) {
  return {error.pos.file, error.pos.line, error.pos.column, error.code};
}

Places places_of(const std::vector<Diagnostic>& errors) {
  Places places;
  for (const Diagnostic& error : errors) places.insert(place_of(error));
  return places;
}

bool is_on(const SourcePos& pos, int line) { return pos.file == 0 && pos.line == line; }

/// Words that do not fit the codes, which may be what is wrong, or a way that all words make
/// together.
bool is_of_line(Code code) {
  constexpr std::array kCodes{Code::SC2003, Code::SC2004, Code::SC2005,
                              Code::SC2006, Code::SC2007, Code::SC4001};
  return std::find(kCodes.begin(), kCodes.end(), code) != kCodes.end();
}

/// Where a line of the text begins and ends.
struct Range {
  std::size_t begin = 0, end = 0;
};

/// Nothing if there is none.
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

/// Bytes of a line, from 0: the first, and the one behind the last.
struct Columns {
  int first = 0, end = 0;
};

/// Calls attempt(text) for all edits of a line between these columns, those near the first of them
/// first.
template <typename Attempt>
void for_each_edit(const std::string& line, Columns columns, Attempt attempt) {
  const auto first = static_cast<std::size_t>(std::max(columns.first - kBeside, 0));
  const auto end = std::min(static_cast<std::size_t>(columns.end + kBeside), line.size());
  for (std::size_t at = first; at <= end; ++at) {
    const bool within = at < end;
    if (within) attempt(std::string(line).erase(at, 1));
    if (at + 1 < line.size() && within) {
      std::string exchanged = line;
      std::swap(exchanged[at], exchanged[at + 1]);
      attempt(exchanged);
    }
    for (const char c : kTried) {
      if (within) attempt(std::string(line).replace(at, 1, 1, c));
      attempt(std::string(line).insert(at, 1, c));
    }
  }
}

/// A word that other lines may lack, a feed, a speed, a tool, and a label: what they lack is an
/// error of their own, whatever else this line could have been.
bool brings_what_others_lack(std::string_view before, std::string_view edited) {
  constexpr std::string_view kLetters = "FSTO";
  const auto count = [](std::string_view line, char letter) {
    return std::count_if(line.begin(), line.end(), [&](char c) { return upper_case(c) == letter; });
  };
  return std::any_of(kLetters.begin(), kLetters.end(),
                     [&](char letter) { return count(edited, letter) > count(before, letter); });
}

struct Mended {
  std::string text;
  std::vector<Diagnostic> left;  // what is wrong with it
};

class Repairs {
 public:
  Repairs(std::string text, const Judge& judge) : text_(std::move(text)), judge_(judge) {
    Verdict verdict = this->verdict(text_);
    lines_run_ = std::move(verdict.lines_run);
    set_wrong(std::move(verdict.errors));
  }

  bool is_wrong(const Diagnostic& error) const { return places_.contains(place_of(error)); }
  const std::vector<Diagnostic>& wrong() const noexcept { return wrong_; }

  /// The line with the edit that leaves the fewest errors; nothing if none mends it.
  std::optional<Mended> mend(int line) {
    const auto range = range_of(text_, line);
    if (!range || range->end - range->begin > kLongestLine) return std::nullopt;
    const std::string before = text_.substr(range->begin, range->end - range->begin);
    std::optional<Mended> best;
    const auto attempt = [&](const std::string& edited) {
      const bool done = work_ > kMostWork || (best && best->left.empty());
      if (done || edited == before || brings_what_others_lack(before, edited)) return;
      std::string text = text_;
      text.replace(range->begin, before.size(), edited);
      Verdict verdict = this->verdict(text);
      if (best && verdict.errors.size() >= best->left.size()) return;
      if (mends(line, verdict)) best = Mended{std::move(text), std::move(verdict.errors)};
    };
    if (stands_twice(line, before)) attempt("");
    for_each_edit(before, columns_told(line), attempt);
    return best;
  }

  void go_on_with(Mended mended) {
    text_ = std::move(mended.text);
    set_wrong(std::move(mended.left));
  }

 private:
  Verdict verdict(const std::string& text) {
    Verdict verdict = judge_(text);
    work_ += kWorkOfTrial + verdict.work;
    return verdict;
  }

  void set_wrong(std::vector<Diagnostic> errors) {
    wrong_ = std::move(errors);
    places_ = places_of(wrong_);
  }

  bool mends(int line, const Verdict& verdict) const {
    const auto stays = [&](const Diagnostic& error) { return is_on(error.pos, line); };
    if (std::any_of(verdict.errors.begin(), verdict.errors.end(), stays)) return false;
    const Places left = places_of(verdict.errors);
    if (!std::includes(places_.begin(), places_.end(), left.begin(), left.end())) return false;
    return std::all_of(wrong_.begin(), wrong_.end(), [&](const Diagnostic& error) {
      const bool goes = !is_on(error.pos, line) && !left.contains(place_of(error));
      return !goes || is_looked_at(error.pos, verdict);
    });
  }

  /// Whether an error there, had it one, would be told as before.
  bool is_looked_at(const SourcePos& pos, const Verdict& verdict) const {
    if (pos.file != 0) return true;
    return lines_run_.contains(pos.line) && verdict.lines_run.contains(pos.line) &&
           !verdict.lines_in_doubt.contains(pos.line);
  }

  bool stands_twice(int line, const std::string& text) const {
    const auto before = line > 1 ? range_of(text_, line - 1) : std::nullopt;
    return before && text_.substr(before->begin, before->end - before->begin) == text;
  }

  /// From the first to the last place of which something is told there; all of the line where any
  /// word of it may be what is wrong.
  Columns columns_told(int line) const {
    std::optional<Columns> columns;
    bool whole = true;
    for (const Diagnostic& error : wrong_) {
      const auto& [at, column, length, file, call] = error.pos;
      if (!is_on(error.pos, line)) continue;
      whole = whole && is_of_line(error.code);
      if (!columns) columns = Columns{column - 1, column - 1};
      columns->first = std::min(columns->first, column - 1);
      columns->end = std::max(columns->end, column - 1 + length);
    }
    return whole ? Columns{0, static_cast<int>(kLongestLine)} : columns.value_or(Columns{});
  }

  std::string text_;
  const Judge& judge_;
  std::vector<Diagnostic> wrong_;  // with the text
  Places places_;                  // of that
  std::map<int, int> lines_run_;   // of the text as it was
  std::int64_t work_ = 0;
};

}  // namespace

std::vector<bool> follow_from_others(std::string text, std::span<const Diagnostic> errors,
                                     const Judge& judge) {
  std::vector<bool> follows(errors.size(), false);
  Repairs repairs(std::move(text), judge);
  std::set<int> mended;  // lines
  const auto mark = [&](int line, const std::vector<Diagnostic>& left) {
    const Places places = places_of(left);
    bool first = true;  // of the line, which is what is told of it
    for (std::size_t i = 0; i < errors.size(); ++i) {
      if (!repairs.is_wrong(errors[i]) || places.contains(place_of(errors[i]))) continue;
      const bool way = errors[i].code == Code::SC4001;
      const bool told = is_on(errors[i].pos, line) && (way || std::exchange(first, false));
      if (!told) follows[i] = true;
    }
  };
  for (int mistakes = 0; mistakes < kMostMistakes && repairs.wrong().size() > 1; ++mistakes) {
    std::optional<Mended> best;
    int line_of_best = 0;
    std::set<int> tried;
    for (std::size_t i = 0; i < errors.size() && tried.size() < kMostLines; ++i) {
      const int line = errors[i].pos.line;
      if (follows[i] || errors[i].pos.file != 0 || !repairs.is_wrong(errors[i])) continue;
      if (errors[i].code == Code::SC2310) continue;  // mended, the loop would not be run
      if (mended.contains(line) || !tried.insert(line).second) continue;
      auto one = repairs.mend(line);
      if (!one || (best && best->left.size() <= one->left.size())) continue;
      best = std::move(one);
      line_of_best = line;
    }
    if (!best) break;
    mark(line_of_best, best->left);
    mended.insert(line_of_best);
    repairs.go_on_with(std::move(*best));
  }
  return follows;
}

}  // namespace softcnc::ipr
