// SPDX-License-Identifier: MIT
// Outputs and inputs: M62 to M68, and the inputs of M52 and M53, as LinuxCNC's manual has them (G
// code reference, sections M62 - M65 to M68).
#include <algorithm>
#include <string>

#include "ipr/codes/code_numbers.hpp"
#include "ipr/handlers/handlers.hpp"

namespace softcnc::ipr {
namespace {

constexpr std::string_view kAdaptiveFeed = "adaptive-feed", kFeedHold = "feed-hold";

std::string port_text(SignalKind kind, std::string_view what, int number) {
  return std::string(name(kind)) + ' ' + std::string(what) + ' ' + std::to_string(number);
}

/// The output that the word with this letter names.
std::optional<OutputPort> output_of(Task& task, SignalKind kind, char letter) {
  const std::string what = "the number of a " + std::string(name(kind)) + " output";
  if (!has_word(task, letter, kind == SignalKind::analog ? "the number of an analog output" : what))
    return std::nullopt;
  const auto number = whole_number(task, task.values.word(letter));
  if (!number) return std::nullopt;
  const auto found = find_port(task.machine.outputs, kind, *number);
  if (found != task.machine.outputs.end()) return found->second;
  report_word(task, letter, Code::SC2240,
              code_name(task.code) + " sets " + port_text(kind, "output", *number) +
                  ", which the machine does not have");
  return std::nullopt;
}

void emit_output(Task& task, const OutputPort& port, double value, bool with_motion) {
  const Action action{Action::Kind::output, task.code.number / kCodesPerNumber, value, port};
  if (with_motion)
    task.out.emit_before_move(action);
  else
    task.out.emit(action);
}

/// The modes of M66 by the number of L.
enum class Wait : std::uint8_t { none, rise, fall, high, low };

bool is_high(double value) noexcept { return value != 0; }

/// What M66 waits for, and how long at most.
struct Waiting {
  Wait wait = Wait::none;
  double longest = 0;  // s
};

std::optional<Waiting> waiting_of(Task& task) {
  constexpr int kModes = 5;
  const Values& values = task.values;
  const auto mode = whole_from(0, values.value_or('L', 0));
  if (!mode || *mode >= kModes) {
    report_word(task, 'L', Code::SC2007, "L of M66 is a whole number from 0 to 4");
    return std::nullopt;
  }
  if (*mode == 0) return Waiting{};
  const std::string name = "M66 L" + std::to_string(*mode);
  const double longest = values.value_or('Q', 0);
  if (values.has('E')) {
    report_word(task, 'L', Code::SC2242, name + " with E: an analog input is read at once");
  } else if (longest <= 0) {
    report_word(task, 'Q', Code::SC2242,
                name + " needs Q, the longest time to wait, in seconds, above 0");
  } else if (longest > kLongestDwell) {
    report_word(task, 'Q', Code::SC2007, "Q of M66 must be 1000000000 s at most");
  } else {
    return Waiting{static_cast<Wait>(*mode), longest};
  }
  return std::nullopt;
}

/// After how many seconds what is waited for comes; nothing if it does not.
std::optional<double> time_until(const InputChange& change, Wait wait) noexcept {
  const bool was_high = is_high(change.before), becomes_high = is_high(change.value);
  if (wait == Wait::rise || wait == Wait::fall) {
    const bool from_high = wait == Wait::fall;
    if (was_high != from_high || becomes_high == from_high) return std::nullopt;
    return change.after;
  }
  const bool wanted = wait == Wait::high;
  if (was_high == wanted && change.after > 0) return 0;
  if (becomes_high == wanted) return change.after;
  return std::nullopt;
}

using Input = InputPorts::const_iterator;

InputChange look_at(Task& task, const Input& input) {
  return task.modal.inputs.look_at(input->first, input->second, task.word.pos.line);
}

/// The input of M66; nothing, after a report, if there is none.
std::optional<Input> input_of(Task& task) {
  const Values& values = task.values;
  if (values.has('P') && values.has('E')) {
    report_word(task, 'E', Code::SC2242, "M66 with P and E: it reads one input");
    return std::nullopt;
  }
  const SignalKind kind = values.has('E') ? SignalKind::analog : SignalKind::digital;
  const char letter = kind == SignalKind::analog ? 'E' : 'P';
  if (!has_word(task, letter, "the number of a digital input, or E, that of an analog one"))
    return std::nullopt;
  const auto number = whole_number(task, values.word(letter));
  if (!number) return std::nullopt;
  const Input found = find_port(task.machine.inputs, kind, *number);
  if (found != task.machine.inputs.end()) return found;
  report_word(
      task, letter, Code::SC2241,
      "M66 reads " + port_text(kind, "input", *number) + ", which the machine does not have");
  return std::nullopt;
}

void wait_in_vain(Task& task, const Input& input, double longest) {
  task.out.report(Code::SC2244, task.word.pos,
                  "M66 waits " + number_text(longest) + " s for input '" + input->first +
                      "' in vain: #5399 is -1");
  task.modal.input_value = -1;
  task.out.emit(Dwell{longest});
}

/// The input of this name and kind that M52 or M53 goes by; nothing, after a report, if the machine
/// has none.
std::optional<Input> input_named(Task& task, std::string_view name, SignalKind kind) {
  const Input found = task.machine.inputs.find(name);
  if (found != task.machine.inputs.end() && found->second.kind == kind) return found;
  task.out.report(Code::SC2241, task.word.pos,
                  code_name(task.code) + " goes by " +
                      (kind == SignalKind::analog ? "an analog" : "a digital") + " input named '" +
                      std::string(name) + "', which the machine does not have; P0 is accepted");
  return std::nullopt;
}

/// M52 P1. LinuxCNC limits the input to 0 to 1; negative ones would run the path backwards.
void adapt_feed(Task& task) {
  const auto input = input_named(task, kAdaptiveFeed, SignalKind::analog);
  if (!input) return;
  const double factor = std::clamp(look_at(task, *input).value, 0.0, 1.0);
  if (factor > 0) {
    task.modal.adaptive_feed = factor;
    return;
  }
  task.out.report(
      Code::SC2243, task.word.pos,
      "M52 takes the feed by input 'adaptive-feed', which is " + number_text(factor) + " here");
}

/// M53 P1: what the input holds goes on once it is off, or else once the operator goes on.
void hold_by_input(Task& task) {
  const auto input = input_named(task, kFeedHold, SignalKind::digital);
  if (!input) return;
  const InputChange change = look_at(task, *input);
  const bool held = is_high(change.after > 0 ? change.before : change.value);
  if (!held) return;
  if (is_high(change.value))
    task.out.emit(Action{Action::Kind::stop, task.code.number / kCodesPerNumber, 0});
  else
    task.out.emit(Dwell{change.after});
}

}  // namespace

/// M62 to M65.
void set_digital_output(Task& task) {
  const int number = task.code.number;
  const auto port = output_of(task, SignalKind::digital, 'P');
  if (!port) return;
  const bool on = number == kM62 || number == kM64;
  emit_output(task, *port, on ? 1 : 0, number == kM62 || number == kM63);
}

/// M67, M68.
void set_analog_output(Task& task) {
  const auto port = output_of(task, SignalKind::analog, 'E');
  if (!port || !has_word(task, 'Q', "the value of the output")) return;
  emit_output(task, *port, task.values['Q'], task.code.number == kM67);
}

/// M66. In simulation the value comes from the table of the input.
void read_input(Task& task) {
  const auto input = input_of(task);
  if (!input) return;
  const auto waiting = waiting_of(task);
  if (!waiting) return;
  const InputChange change = look_at(task, *input);
  if (waiting->wait == Wait::none) {
    task.modal.input_value = change.after > 0 ? change.before : change.value;
    return task.out.emit(Dwell{0});
  }
  const auto time = time_until(change, waiting->wait);
  if (!time || *time > waiting->longest) return wait_in_vain(task, *input, waiting->longest);
  const bool high = waiting->wait == Wait::rise || waiting->wait == Wait::high;
  task.modal.input_value = high ? 1 : 0;
  task.out.emit(Dwell{*time});
}

/// M52, M53.
void switch_input(Task& task) {
  const bool on = task.values.value_or('P', 1) != 0;
  if (task.code.number == kM53) {
    if (on) hold_by_input(task);
  } else if (on) {
    adapt_feed(task);
  } else {
    task.modal.adaptive_feed = 1;
  }
}

}  // namespace softcnc::ipr
