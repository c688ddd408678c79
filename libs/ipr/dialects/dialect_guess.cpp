// SPDX-License-Identifier: MIT
#include "ipr/dialects/dialect_guess.hpp"

#include <fnmatch.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "ipr/dialects/sender_lines.hpp"
#include "ipr/text/reader.hpp"

namespace softcnc::ipr {
namespace {

constexpr int kEnough = 3;  // weights of marks
constexpr Dialect kLinuxcnc = Dialect::linuxcnc, kFanuc = Dialect::fanuc, kHaas = Dialect::haas,
                  kGrbl = Dialect::grbl;

/// The name of a control in a comment.
struct NameMark {
  Dialect dialect;
  const char* name;
};
constexpr NameMark kNameMarks[] = {{kLinuxcnc, "LINUXCNC"}, {kLinuxcnc, "EMC2"},
                                   {kFanuc, "FANUC"},       {kHaas, "HAAS"},
                                   {kGrbl, "GRBL"},         {kGrbl, "FLUIDNC"}};

/// Codes by ten times their number, from the first to the last one.
struct CodeMark {
  Dialect dialect;
  int weight;
  char letter;
  int first, last;
};
constexpr CodeMark kCodeMarks[] = {
    {kHaas, 3, 'G', 1540, 1540},   {kHaas, 3, 'G', 1870, 1870},   {kHaas, 3, 'G', 1100, 1299},
    {kHaas, 3, 'G', 1500, 1500},   {kHaas, 3, 'G', 120, 120},     {kHaas, 3, 'G', 130, 130},
    {kHaas, 2, 'M', 970, 970},     {kHaas, 1, 'G', 1030, 1030},   {kFanuc, 3, 'G', 541, 541},
    {kFanuc, 2, 'G', 650, 661},    {kFanuc, 2, 'M', 290, 290},    {kFanuc, 1, 'M', 980, 990},
    {kFanuc, 1, 'G', 680, 680},    {kFanuc, 1, 'G', 160, 160},    {kFanuc, 1, 'G', 100, 100},
    {kLinuxcnc, 3, 'G', 330, 331}, {kLinuxcnc, 2, 'G', 52, 53},   {kLinuxcnc, 2, 'G', 432, 432},
    {kLinuxcnc, 1, 'M', 620, 680}, {kLinuxcnc, 1, 'G', 591, 593}, {kLinuxcnc, 1, 'G', 922, 923},
    {kLinuxcnc, 1, 'G', 611, 611},
};

/// A pattern as of file names (POSIX, fnmatch), of a line in capitals without blanks, comments and
/// a number of its own.
struct LineMark {
  Dialect dialect;
  int weight;
  const char* pattern;
  const char* says;
};
constexpr LineMark kLineMarks[] = {
    {kLinuxcnc, 3, "O*[]0-9>]SUB", "an O-word"},
    {kLinuxcnc, 3, "O*[]0-9>]CALL*", "an O-word"},
    {kLinuxcnc, 3, "O*[]0-9>]IF[[]*", "an O-word"},
    {kLinuxcnc, 3, "O*[]0-9>]WHILE[[]*", "an O-word"},
    {kLinuxcnc, 3, "O*[]0-9>]REPEAT[[]*", "an O-word"},
    {kLinuxcnc, 3, "O*[]0-9>]DO", "an O-word"},
    {kLinuxcnc, 3, "*#<*>*", "a variable with a name"},
    {kLinuxcnc, 2, "*G64*P*", "G64 P"},
    {kHaas, 3, "[[]*]M99*", "a condition before M99"},
    {kHaas, 3, "*G7[012]*I*L*", "a pattern of holes"},
    {kFanuc, 3, "WH*[[]*]DO[123]", "WHILE DO"},
    {kFanuc, 3, "IF[[]*]THEN*", "IF THEN"},
    {kFanuc, 3, "IF[[]*]GOTO*", "IF GOTO"},
    {kFanuc, 2, "GOTO[0-9]*", "GOTO"},
    {kFanuc, 3, "#3000=*", "#3000"},
    {kFanuc, 2, "#[15][0-9][0-9]=*", "a common variable"},
    {kFanuc, 3, "*#[0-9]*=#[0-9]*[-+*/]*", "an operator without brackets"},
    {kFanuc, 3, "*G05.1Q*", "G05.1 Q"},
    {kFanuc, 3, "*G5.1Q*", "G05.1 Q"},
    {kFanuc, 3, "*G05P[0-9]*", "G05 P"},
    {kFanuc, 2, "*G08P[01]*", "G08 P"},
    {kFanuc, 1, "*G04[XU]*", "G04 X"},
    {kFanuc, 1, "*G30P[234]*", "G30 P"},
};

constexpr std::size_t kFirstCode = std::size(kNameMarks);
constexpr std::size_t kFirstLine = kFirstCode + std::size(kCodeMarks);
constexpr std::size_t kSender = kFirstLine + std::size(kLineMarks);
constexpr std::size_t kChecksum = kSender + 1, kStart = kSender + 2, kNumber = kSender + 3;
constexpr std::size_t kMarks = kSender + 4;

/// The text in capitals: what stands in comments, and the code without blanks.
std::pair<std::string, std::string> parts_of(std::string_view line) {
  std::string comments, code;
  bool in_comment = false;
  for (std::size_t at = 0; at < line.size(); ++at) {
    char c = line[at];
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    if (!in_comment && c == ';') {
      for (; at < line.size(); ++at)
        comments +=
            static_cast<char>(line[at] >= 'a' && line[at] <= 'z' ? line[at] - 'a' + 'A' : line[at]);
      break;
    }
    if (c == '(') in_comment = true;
    if (in_comment)
      comments += c;
    else if (c != ' ' && c != '\t')
      code += c;
    if (c == ')') in_comment = false;
  }
  return {std::move(comments), std::move(code)};
}

void drop_line_number(std::string& code) {
  if (code.starts_with('/')) code.erase(0, 1);
  if (code.empty() || code.front() != 'N') return;
  code.erase(0, std::min(code.find_first_not_of("0123456789", 1), code.size()));
}

/// Ten times the number at the beginning; negative if there is none of a code.
int tenths_at(std::string_view text) noexcept {
  constexpr int kMost = 10000;
  int tenths = -1;
  std::size_t at = 0;
  const auto digit = [&] { return at < text.size() && text[at] >= '0' && text[at] <= '9'; };
  for (; digit() && tenths < kMost; ++at) tenths = std::max(tenths, 0) * 10 + 10 * (text[at] - '0');
  if (at + 1 < text.size() && text[at] == '.') ++at;
  if (tenths >= 0 && at > 0 && text[at - 1] == '.' && digit()) tenths += text[at] - '0';
  return tenths < kMost ? tenths : -1;
}

/// Alone on a line: `O0012`, `:0012`, or a name as newer controls of FANUC have them, `<PLATE>`.
bool names_program(std::string_view code) noexcept {
  if (code.size() < 2) return false;
  const bool named = code.front() == '<' && code.find('>') == code.size() - 1;
  const bool number = code.front() == 'O' || code.front() == ':';
  return named || (number && code.find_first_not_of("0123456789", 1) == code.npos);
}

bool is_axis(char letter) noexcept { return letter >= 'X' && letter <= 'Z'; }

std::string code_text(char letter, int tenths) {
  std::string text(1, letter);
  if (tenths < 100) text += '0';
  text += std::to_string(tenths / 10);
  if (tenths % 10 != 0) text += '.' + std::to_string(tenths % 10);
  return text;
}

}  // namespace

void DialectGuess::add(std::size_t kind, Dialect dialect, int weight, std::string mark) {
  static_assert(kMarks <= kMostMarks);
  if (seen_[kind]) return;
  seen_.set(kind);
  Evidence& evidence = evidence_[static_cast<std::size_t>(dialect)];
  evidence.weight += weight;
  if (weight <= evidence.heaviest) return;
  evidence.heaviest = weight;
  evidence.mark = std::move(mark);
  evidence.text = line_;
  evidence.line = number_;
}

void DialectGuess::see(std::string_view line, int number) {
  if (line.find('\0') != line.npos) return;  // damaged, or in another encoding
  line_ = line;
  number_ = number;
  auto [comments, code] = parts_of(line);
  see_comments(comments);
  if (is_sender_line(line)) return add(kSender, kGrbl, kEnough, "a line for a sender of grbl");
  if (const std::size_t star = checksum_at(code); star != code.npos) {
    add(kChecksum, kGrbl, kEnough, "a checksum of a sender");
    code.erase(star);
  }
  drop_line_number(code);
  if (code.empty()) return;
  see_code(code);
  see_words(code);
}

void DialectGuess::see_comments(std::string_view comments) {
  for (std::size_t i = 0; i < std::size(kNameMarks); ++i)
    if (comments.find(kNameMarks[i].name) != comments.npos)
      add(i, kNameMarks[i].dialect, kEnough,
          std::string("'") + kNameMarks[i].name + "' in a comment");
}

void DialectGuess::see_code(const std::string& code) {
  if (names_program(code)) add(kNumber, kFanuc, 2, "the number of a program");
  for (std::size_t i = 0; i < std::size(kLineMarks); ++i) {
    const LineMark& mark = kLineMarks[i];
    if (!seen_[kFirstLine + i] && ::fnmatch(mark.pattern, code.c_str(), FNM_NOESCAPE) == 0)
      add(kFirstLine + i, mark.dialect, mark.weight, mark.says);
  }
}

/// Letters with numbers; what is computed shows nothing.
void DialectGuess::see_words(const std::string& code) {
  bool other_use = false, axes = false;
  for (std::size_t at = 0; at < code.size(); ++at) {
    const char letter = code[at];
    if (letter < 'A' || letter > 'Z') {
      if (letter == '#' || letter == '[' || letter == '$') return;
      continue;
    }
    axes = axes || is_axis(letter);
    if (letter != 'G' && letter != 'M') continue;
    const int tenths = tenths_at(std::string_view(code).substr(at + 1));
    if (tenths < 0) continue;
    for (std::size_t i = 0; i < std::size(kCodeMarks); ++i) {
      const CodeMark& mark = kCodeMarks[i];
      if (letter == mark.letter && tenths >= mark.first && tenths <= mark.last)
        add(kFirstCode + i, mark.dialect, mark.weight, code_text(letter, tenths));
    }
    if (letter != 'G') continue;
    constexpr int kModal[] = {170, 180, 190, 200, 210, 400, 490, 540, 550,
                              560, 570, 580, 590, 640, 800, 900, 910, 940};
    const bool modal = std::find(std::begin(kModal), std::end(kModal), tenths) != std::end(kModal);
    other_use = other_use || !modal;
    moves_ = moves_ || tenths <= 30 || (tenths >= 50 && tenths <= 62) ||
             (tenths >= 730 && tenths <= 890 && tenths != 800);
  }
  if (axes && !moves_ && !other_use && code.front() != 'O')
    add(kStart, kGrbl, kEnough, "coordinates before any motion code");
  moves_ = moves_ || axes;
}

/// O-words, named variables, names of controls and what is for senders: where one of them is, a
/// number is only one mark among others.
bool DialectGuess::may_be_numbered_elsewhere() const noexcept {
  bool may = seen_[kSender] || seen_[kChecksum];
  for (std::size_t i = 0; i < std::size(kNameMarks); ++i)
    may = may || (seen_[i] && is_linuxcnc_like(kNameMarks[i].dialect));
  for (std::size_t i = 0; i < std::size(kLineMarks); ++i) {
    const LineMark& mark = kLineMarks[i];
    may = may || (seen_[kFirstLine + i] && mark.dialect == kLinuxcnc && mark.weight == kEnough);
  }
  return may;
}

/// Haas' controls have the marks of FANUC's beside their own.
std::array<int, kDialects> DialectGuess::weights() const noexcept {
  std::array<int, kDialects> all{};
  for (std::size_t i = 0; i < kDialects; ++i) all[i] = evidence_[i].weight;
  int& fanuc = all[static_cast<std::size_t>(kFanuc)];
  int& haas = all[static_cast<std::size_t>(kHaas)];
  if (seen_[kNumber] && !may_be_numbered_elsewhere()) {
    fanuc = std::max(fanuc, kEnough);
    all[static_cast<std::size_t>(kLinuxcnc)] = all[static_cast<std::size_t>(kGrbl)] = 0;
  }
  if (haas > 0) haas += fanuc;
  return all;
}

std::optional<Dialect> DialectGuess::dialect() const noexcept {
  const auto all = weights();
  const int most = *std::max_element(all.begin(), all.end());
  if (most < kEnough || std::count(all.begin(), all.end(), most) > 1) return std::nullopt;
  return kAllDialects[static_cast<std::size_t>(std::find(all.begin(), all.end(), most) -
                                               all.begin())];
}

const DialectGuess::Evidence& DialectGuess::best() const noexcept {
  return evidence_[static_cast<std::size_t>(dialect().value_or(kLinuxcnc))];
}

namespace {

/// Of a text that may go on, the last line may not be all there.
std::string whole_lines(std::string_view text) {
  if (text.size() > Reader::kLongestLine) text = text.substr(0, text.find_last_of("\r\n") + 1);
  return std::string(text);
}

}  // namespace

DialectGuess guess_dialect(Reader& reader) {
  while (std::count(reader.unread().begin(), reader.unread().end(), '\n') < DialectGuess::kLines &&
         reader.read_ahead()) {
  }
  DialectGuess guess;
  if (reader.waiting()) return guess;
  Reader lines = Reader::from_text(whole_lines(reader.unread()));
  while (lines.line() < DialectGuess::kLines) {
    const auto line = lines.next();
    if (!line) break;
    guess.see(*line, lines.line());
  }
  return guess;
}

}  // namespace softcnc::ipr
