// SPDX-License-Identifier: MIT
// The lines of grbl that begin with '$', jogs among them.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "ipr/interpreter/memory.hpp"
#include "motion/core/units.hpp"
#include "serve/grbl_control.hpp"
#include "serve/grbl_numbers.hpp"

namespace softcnc::app {
namespace {

using runtime::MachineMode;

std::string without_blanks(std::string_view line) {
  std::string text;
  for (const char c : line)
    if (c != ' ' && c != '\t') text += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  return text;
}

std::optional<double> number_of(std::string_view text) {
  double number = 0;
  const auto [end, error] =
      std::from_chars(text.data(), text.data() + text.size(), number, std::chars_format::fixed);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  return whole ? std::optional(number) : std::nullopt;
}

/// Why the words of a jog are none, by grbl's number.
const char* error_of_jog(int error) noexcept {
  switch (error) {
    case GrblError::kNoFeed:
      return "needs a feed: F, above 0";
    case GrblError::kRepeated:
      return "has a word twice";
    case GrblError::kNoNumber:
      return "has a word without a number";
    default:
      return "takes X Y Z, F, G20, G21, G53, G90 and G91";
  }
}

}  // namespace

void GrblControl::dollar(const std::string& line) {
  const std::string text = without_blanks(line);
  const auto mode = machine_.control().mode();
  const bool idle = mode == MachineMode::idle || mode == MachineMode::alarm;
  if (text.starts_with("$J=")) return jog(std::string_view(text).substr(3));
  if (text == "$$" && !idle && mode != MachineMode::check) return say_error(GrblError::kNotIdle);
  std::string answer;
  if (text == "$") answer = GrblReports::help();
  if (text == "$$") answer = reports_.settings(machine_.machine());
  if (text == "$#") answer = reports_.offsets(machine_);
  if (text == "$G") answer = reports_.modes(machine_);
  if (text == "$I") answer = GrblReports::build();
  if (text == "$N") answer = "$N0=\r\n$N1=";
  if (!answer.empty()) {
    say(answer);
    return say("ok");
  }
  if (text == "$X") return unlock();
  if (text == "$H") return home();
  if (text == "$C" || text == "$SLP") {
    const bool ends_check = mode == MachineMode::check;
    const bool may =
        text == "$C" ? (mode == MachineMode::idle && !is_locked()) || ends_check : idle;
    if (!may) return say_error(GrblError::kNotIdle);
    static_cast<void>(text == "$C" ? machine_.control().check() : machine_.control().sleep());
    journal_.add(EntryKind::action, text);
    say(text == "$SLP" ? "[MSG:Sleeping]" : ends_check ? "[MSG:Disabled]" : "[MSG:Enabled]");
    say("ok");
    if (ends_check) begin_again();
    return;
  }
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) return say_error(GrblError::kStatement);
  set(std::string_view(text).substr(1, equals - 1), std::string_view(text).substr(equals + 1));
}

/// What the machine file says stays as it is; to say the same again is no error.
void GrblControl::set(std::string_view number, std::string_view value) {
  const auto mode = machine_.control().mode();
  if (mode != MachineMode::idle && mode != MachineMode::alarm)
    return say_error(GrblError::kNotIdle);
  const auto wanted = number_of(value), which = number_of(number);
  constexpr double kLargest = 255;
  if (!wanted || !which || *which < 0 || *which > kLargest) return say_error(GrblError::kStatement);
  if (reports_.set(static_cast<int>(*which), *wanted, machine_.machine())) return say("ok");
  say(fmt::format("[MSG:${} is what the machine file says]", number));
  say_error(GrblError::kStatement);
}

/// Where the place of the machine is not known, its operator says with this that it is the one that
/// reports show.
void GrblControl::unlock() {
  const bool was_locked = is_locked();
  if (resetting_) return say_error(GrblError::kNotIdle);
  if (locked_ && !machine_.control().knows_position())
    static_cast<void>(machine_.control().set_position(machine_.control().position()));
  locked_ = false;
  if (!requests_.unlock()) return say_error(GrblError::kNotIdle);
  if (was_locked) say("[MSG:Caution: Unlocked]");
  say("ok");
}

void GrblControl::home() {
  const auto mode = machine_.control().mode();
  if (mode != MachineMode::idle && mode != MachineMode::alarm)
    return say_error(GrblError::kNotIdle);
  if (resetting_ || machine_.control().in_motion()) return say_error(GrblError::kNotIdle);
  if (!runtime::Homing::is_possible(machine_.machine())) return say_error(GrblError::kNoHoming);
  waiting_.clear();
  if (!requests_.home()) return say_error(GrblError::kNoHoming);
  wait_ = Wait::homed;
}

void GrblControl::jog(std::string_view words) {
  const auto mode = machine_.control().mode();
  const bool may = mode == MachineMode::jog || (mode == MachineMode::idle && !is_locked());
  if (!may) return say_error(GrblError::kNotIdle);
  const GrblWords read = read_words(words);
  int error = GrblError::kNoNumber;
  const auto jog = read.is_all ? jog_of(read.words, error) : std::nullopt;
  if (!jog) {
    say(fmt::format("[MSG:a jog {}]", error_of_jog(error)));
    return say_error(error);
  }
  if (jog->distance.isZero(0)) return say("ok");  // it is there
  journal_.add(EntryKind::action, fmt::format("jog {}", words));
  const Status taken = machine_.control().jog(*jog);
  if (!taken) {
    journal_.add(taken.error());
    return refuse(taken.error());
  }
  say("ok");
}

/// "G91X1F100", in the units and distances of this line alone. A place counts from where the jog
/// before it ends.
std::optional<runtime::Jog> GrblControl::jog_of(const std::vector<GrblWord>& words,
                                                int& error) const {
  const runtime::Operator& control = machine_.control();
  double unit = control.mm_per_unit(), feed = 0;
  bool incremental = control.memory().modal.incremental, in_machine = false;
  std::array<std::optional<double>, kAxes> given;
  error = GrblError::kRepeated;
  for (std::size_t i = 1; i < words.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (words[i].letter == words[k].letter && words[i].letter != 'G') return std::nullopt;
  error = GrblError::kJogWords;
  for (const GrblWord& word : words) {
    const auto axis = std::find(kAxisLetters.begin(), kAxisLetters.end(), word.letter);
    if (axis != kAxisLetters.end())
      given[static_cast<std::size_t>(axis - kAxisLetters.begin())] = word.number;
    else if (word.letter == 'F')
      feed = word.number;
    else if (word.letter == 'G' && (word.number == 20 || word.number == 21))
      unit = word.number == 20 ? kMmPerInch : 1;
    else if (word.letter == 'G' && (word.number == 90 || word.number == 91))
      incremental = word.number == 91;
    else if (word.letter == 'G' && word.number == 53)
      in_machine = true;
    else if (word.letter != 'N' &&
             !(word.letter == 'G' && (word.number == 93 || word.number == 94)))
      return std::nullopt;
  }
  if (std::none_of(given.begin(), given.end(), [](const auto& one) { return one.has_value(); }))
    return std::nullopt;
  error = GrblError::kNoFeed;
  if (feed <= 0) return std::nullopt;
  runtime::Jog jog;
  jog.feed = mm_s_from_mm_min(feed * unit);
  const AxisVector from = control.position() + control.to_go();
  const AxisVector base = in_machine ? from : control.programmed(from);
  for (std::size_t axis = 0; axis < kAxes; ++axis)
    if (given[axis]) {
      const auto i = static_cast<Eigen::Index>(axis);
      jog.distance[i] = *given[axis] * unit - (incremental ? 0 : base[i]);
    }
  return jog;
}

}  // namespace softcnc::app
