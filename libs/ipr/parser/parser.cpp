// SPDX-License-Identifier: MIT
// Reads words up to the first that is wrong, which is reported with its cause.
#include "ipr/parser/parser.hpp"

#include <string>
#include <utility>

#include "ipr/dialects/grbl_reading.hpp"
#include "ipr/text/text_errors.hpp"

namespace softcnc::ipr {
namespace {

/// M66, whose E is a word and no exponent.
bool takes_e(const Word& word) noexcept { return word.letter == 'M' && word.value == 66; }

}  // namespace

void Parser::configure(const ParserOptions& options) {
  options_ = options;
  parameters_ = Parameters(options.dialect);
  if (options.differences != nullptr && options.differences->watching()) parameters_.watch();
}

std::optional<ProgramLine> Parser::next() {
  reader_->wait();
  return next_line([this] { read_line(Depth::usual); });
}

std::optional<ProgramLine> Parser::next_if_there() {
  reader_->do_not_wait();
  return next_line([this] { read_line(Depth::usual); });
}

std::optional<ProgramLine> Parser::next_statement() {
  reader_->wait();
  return next_line([this] { read_outline(); });
}

ProgramLine Parser::evaluate() {
  begin_line(line_.text);
  read_line(Depth::whole);
  if (file_ != 0) name_file();
  return line_;
}

void Parser::read_on(Reader& reader, int file, bool at_beginning) noexcept {
  reader_ = &reader;
  file_ = file;
  started_ = !at_beginning;
  lone_percent_ = {};
  ended_ = false;
}

/// Says in the places of the line which file it is of.
void Parser::name_file() noexcept {
  for (Word& word : words_) word.pos.file = file_;
  statement_.pos.file = file_;
}

/// Reads lines until one has something to say.
template <typename Read>
std::optional<ProgramLine> Parser::next_line(Read read) {
  while (!ended_) {
    const auto text = reader_->next();
    if (!text && reader_->waiting()) return std::nullopt;
    if (!text) break;
    begin_line(*text);
    if (lone_percent_.line > 0 && goes_on_after_end()) break;
    read();
    if (ended_) break;
    const bool shown = line_.skipped && skipped_too_;
    const bool says_nothing =
        words_.empty() && line_.statement == nullptr && line_.corner == nullptr && !shown;
    if (says_nothing && !line_.broken && line_.stock.empty()) continue;
    if (!line_.broken && !says_nothing) started_ = true;
    if (file_ != 0) name_file();
    return line_;
  }
  if (!ended_ && reader_->failure()) {
    Diagnostic failure = *reader_->failure();
    failure.pos.file = file_;
    diagnostics_.report(std::move(failure));
    broke_off_ = true;
  }
  ended_ = true;
  return std::nullopt;
}

[[gnu::hot]] void Parser::begin_line(std::string_view text) {
  bytes_read_ += static_cast<std::int64_t>(text.size());
  words_.clear();
  assignments_.clear();
  before_.clear();
  line_ = ProgramLine{};
  line_.number = reader_->line();
  line_.text = code_ = text;
  given_up_ = false;
  begin_ = 1;
}

void Parser::read_line(Depth depth) {
  depth_ = depth;
  parameters_.set_line(line_.number);
  if (!is_readable()) return;
  if (options_.dialect == Dialect::grbl && skip_sender_line()) return;
  read_words();
  if (!assignments_.empty()) apply_assignments();
  if (const int number = parameters_.take_assumed(); number != 0) report_assumed(number);
  line_.words = words_;
  if (options_.dialect == Dialect::grbl) note_computed();
}

/// At the first variable of the line, which need not be the one.
[[gnu::cold]] void Parser::report_assumed(int number) {
  const std::size_t sign = line_.text.find('#');
  const int column = sign == std::string_view::npos ? 1 : static_cast<int>(sign) + 1;
  report(Code::SC2386, column, 1,
         "#" + std::to_string(number) +
             " counts the diameter of a tool, as Haas' setting 40 has it "
             "unless it says radius");
}

bool Parser::is_readable() {
  const auto encoding = line_.number == 1 ? wide_encoding(line_.text) : std::string_view{};
  if (!encoding.empty()) {
    refuse_file(encoding);
  } else if (reader_->line_was_cut()) {
    give_up(Code::SC1015, 1, 1,
            "the line is longer than " + std::to_string(Reader::kLongestLine) + " bytes");
  }
  return !given_up_;
}

/// grbl's senders keep such lines to themselves, and take a checksum off before they send a line.
/// False: there is something to read.
bool Parser::skip_sender_line() {
  const bool whole = is_sender_line(line_.text);
  const std::size_t star = whole ? 0 : checksum_at(line_.text);
  if (star == std::string_view::npos) return false;
  sender_lines_.note({line_.number, static_cast<int>(star) + 1, 1, file_}, line_.text);
  code_ = code_.substr(0, star);
  return whole;
}

/// Once a file: grbl computes nothing.
void Parser::note_computed() {
  const std::size_t at = computed_at(line_.text);
  if (at == std::string_view::npos || line_.broken || !computed_.insert(file_).second) return;
  diagnostics_.report(Code::SC1056, {line_.number, static_cast<int>(at) + 1, 1, file_},
                      "grbl 1.1 has no O-words, variables and expressions", line_.text);
}

/// No line of it can be read, or shown.
void Parser::refuse_file(std::string_view encoding) {
  line_.text = {};
  TextError error = wide_error(encoding);
  give_up(error.code, 1, 1, std::move(error.message));
  ended_ = broke_off_ = true;
}

[[gnu::hot]] void Parser::read_words() {
  Lexer lexer(code_);
  for (PlainWord plain; lexer.take_plain_word(plain);) {
    Word& word = words_.emplace_back();
    word.letter = plain.letter;
    word.value = plain.value;
    word.pos = {line_.number, plain.column, plain.length};
  }
  Token token = lexer.next();
  while (token.kind != Token::Kind::end && !given_up_ && !ended_) {
    begin_ = token.column;
    token = token.kind == Token::Kind::letter ? read_word(lexer, token) : read_mark(lexer, token);
  }
  if (lexer.comment_column() > 0) obey_comment(lexer.comment_column());
}

/// Returns the first token that does not belong to the word.
Token Parser::read_word(Lexer& lexer, const Token& letter) {
  const bool may_be_exponent = letter.letter == 'E' && is_linuxcnc_like(options_.dialect);
  if (may_be_exponent && has_word_before(letter.column) && !takes_e(words_.back())) {
    refuse_exponent(lexer, letter);
    return {};
  }
  if (letter.letter == 'O' && read_o_word(lexer, letter)) return {};
  const Token number = lexer.next();
  if (number.kind != Token::Kind::number || number.error == NumberError::no_digits)
    return read_value(lexer, letter, number);
  if (number.error != NumberError::none) {
    refuse_number(letter, number);
    return {};
  }
  const int length = number.end_column() - letter.column;
  words_.push_back({letter.letter, number.value, {line_.number, letter.column, length}});
  return lexer.next();
}

}  // namespace softcnc::ipr
