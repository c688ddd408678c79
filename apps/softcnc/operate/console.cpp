// SPDX-License-Identifier: MIT
#include "operate/console.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "motion/core/units.hpp"
#include "operate/views.hpp"

namespace softcnc::app {
namespace {

constexpr double kAtRest = 0;  // s

/// The axis of a jog key, and its direction.
struct JogDirection {
  int axis = -1;
  int sign = 0;
};

JogDirection direction_of(Key::Kind key) noexcept {
  switch (key) {
    case Key::Kind::left:
      return {0, -1};
    case Key::Kind::right:
      return {0, 1};
    case Key::Kind::down:
      return {1, -1};
    case Key::Kind::up:
      return {1, 1};
    case Key::Kind::page_down:
      return {2, -1};
    case Key::Kind::page_up:
      return {2, 1};
    default:
      return {};
  }
}

constexpr const char* kShown = ": v shows what the check has found";

std::string counted(int count, const char* what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

}  // namespace

Console::Console(AttendedMachine& machine, Journal& journal, std::function<bool()> is_stopped)
    : machine_(machine),
      journal_(journal),
      is_stopped_(std::move(is_stopped)),
      requests_(machine, journal) {}

// Keys --------------------------------------------------------------------------------------------

void Console::key(const Key& key, double now) {
  now_ = now;
  journal_.set_time(now);
  const bool jogs = !state_.prompt && state_.page == Page::main && direction_of(key.kind).axis >= 0;
  if (jogs) return jog_key(key.kind);
  const bool ends_jog = jog_keys_.is_continuous();
  act_on_jog(jog_keys_.release(), key.kind);
  if (ends_jog && key != key_of('e')) return;  // that is all it does
  if (key.kind == Key::Kind::interrupt) {
    hold();
  } else if (state_.prompt) {
    key_of_prompt(key);
  } else if (state_.page == Page::main) {
    key_of_page(key);
  } else {
    key_of_list(key);
  }
}

void Console::jog_key(Key::Kind key) { act_on_jog(jog_keys_.press(key, now_), key); }

void Console::act_on_jog(JogKeys::Act act, Key::Kind key) {
  if (act == JogKeys::Act::nothing) return;
  if (act == JogKeys::Act::stop) {
    requests_.cancel();
    return;
  }
  const auto [axis, sign] = direction_of(key);
  const double step = kJogSteps[state_.jog_step];
  runtime::Jog jog;
  jog.distance[axis] = sign * step;
  jog.feed = mm_s_from_mm_min(kJogFeeds[state_.jog_feed]);
  jog.continuous = act == JogKeys::Act::begin;
  const char letter = kAxisLetters[static_cast<std::size_t>(axis)];
  const std::string what = jog.continuous ? fmt::format("{}{}", letter, sign > 0 ? '+' : '-')
                                          : fmt::format("{}{:+g}", letter, sign * step);
  if (!requests_.jog(jog, what)) jog_keys_.release();
}

void Console::key_of_page(const Key& key) {
  if (key.kind == Key::Kind::enter) return go_on();
  if (key.kind != Key::Kind::character) return;
  for (const Binding& binding : bindings())
    if (binding.key == key.character) return binding.act(*this);
}

void Console::key_of_list(const Key& key) {
  if (key.kind == Key::Kind::escape || key == key_of('q')) return show(Page::main);
  if (key.kind == Key::Kind::up && state_.selection > 0) --state_.selection;
  if (key.kind == Key::Kind::down && state_.selection < last_row(state_, machine_))
    ++state_.selection;
  if (key.kind == Key::Kind::enter) ask_for_row();
  if (state_.page == Page::work && key == key_of('a'))
    requests_.line(work_system_name(state_.selection));
  if (state_.page == Page::tools) key_of_tools(key);
}

void Console::key_of_prompt(const Key& key) {
  LineEditor& editor = state_.prompt->what == Prompt::For::line ? lines_ : answers_;
  if (key.kind == Key::Kind::escape) {
    editor.clear();
    state_.prompt.reset();
    if (machine_.control().is_line_open()) {
      machine_.control().forget_lines();
      journal_.add(EntryKind::note, "the lines of the loop that was not closed are forgotten");
    }
  } else if (key.kind == Key::Kind::enter) {
    take(editor.take());
  } else {
    editor.key(key);
  }
}

// Programs ----------------------------------------------------------------------------------------

void Console::load(const std::string& file) {
  journal_.add(EntryKind::action, "load " + file);
  if (state_.runs || machine_.control().in_motion())
    return journal_.add(EntryKind::fault, "load: the machine moves, or a program is held");
  auto program = LoadedProgram::open(file);
  if (!program) return journal_.add(EntryKind::fault, file + ": " + program.error().message);
  state_.program.emplace(std::move(*program));
  if (machine_.control().knows_position()) check();
}

/// Returns whether the program may run from the present state.
bool Console::check() {
  if (!state_.program) {
    journal_.add(EntryKind::fault, "no program is loaded: l loads one");
    return false;
  }
  const runtime::Operator& control = machine_.control();
  if (control.in_motion() || state_.runs) {
    journal_.add(EntryKind::fault, "check: the machine moves, or a program is held");
    return false;
  }
  runtime::ChannelOptions options = machine_.checking_options();
  options.interpreter.block_skip = requests_.switches().block_skip;
  options.interpreter.optional_stop = requests_.switches().optional_stop;
  if (state_.program->has_changed() && !read_again()) return false;
  if (!state_.program->checked(options))
    state_.program->check(machine_.machine(), options, is_stopped_);
  const CheckedProgram* checked = state_.program->checked(options);
  if (checked == nullptr)
    journal_.add(EntryKind::note, "the check was ended");
  else if (checked->errors > 0)
    journal_.add(EntryKind::fault, counted(checked->errors, "error") + kShown);
  else if (checked->warnings > 0)
    journal_.add(EntryKind::note, counted(checked->warnings, "warning") + kShown);
  return checked != nullptr && checked->passed;
}

bool Console::read_again() {
  auto program = LoadedProgram::open(state_.program->name());
  if (!program) {
    journal_.add(program.error());
    return false;
  }
  journal_.add(EntryKind::note, "the file has changed: it was read again");
  state_.program.emplace(std::move(*program));
  return true;
}

void Console::start() {
  const bool may_run = machine_.control().mode() == runtime::MachineMode::check ||
                       !machine_.control().knows_position() || check();
  if (!may_run || !state_.program || !requests_.start(*state_.program)) return;
  state_.runs = machine_.control().in_program();
  state_.line = 0;
}

/// At rest there is nothing to hold.
void Console::hold() {
  const auto mode = machine_.control().mode();
  if (mode == runtime::MachineMode::alarm)
    requests_.cancel();
  else if (mode != runtime::MachineMode::idle)
    requests_.hold();
}

void Console::go_on() {
  using enum runtime::MachineMode;
  const auto mode = machine_.control().mode();
  if (mode == hold || mode == door) requests_.resume();
}

void Console::quit() {
  using enum runtime::MachineMode;
  const auto mode = machine_.control().mode();
  const bool is_held = mode == hold || mode == door;
  if (machine_.control().in_motion() || is_held) {
    journal_.add(EntryKind::action, "quit");
    return journal_.add(EntryKind::fault,
                        "quit: the machine moves, or a program is held; a ends it");
  }
  requests_.reset();
  is_over_ = true;
}

// Time --------------------------------------------------------------------------------------------

Status Console::advance(double now) {
  now_ = now;
  journal_.set_time(now);
  act_on_jog(jog_keys_.wait(now), Key::Kind::unknown);
  Status moved = machine_.advance(now);
  if (!moved) {
    if (machine_.control().in_motion()) requests_.hold();
    journal_.add(moved.error());  // after the request, which clears what was shown
  }
  settle();
  if (is_alone_) wait_alone();
  return moved;
}

/// What follows from where the machine has come to.
void Console::settle() {
  const runtime::Operator& control = machine_.control();
  if (state_.runs && control.last().line > 0) state_.line = control.last().line;
  if (const runtime::Pause* pause = control.pause()) state_.line = pause->block.source.line;
  if (probes_ && control.mode() != runtime::MachineMode::run) restore_modes();
  if (state_.runs && !control.in_program()) {
    state_.runs = false;
    journal_.add(EntryKind::note,
                 control.has_completed() ? "the program has ended" : "the program was broken off");
  }
}

/// However probing has ended; in Hold it has not.
void Console::restore_modes() {
  const auto mode = machine_.control().mode();
  if (mode == runtime::MachineMode::hold || mode == runtime::MachineMode::door) return;
  probes_ = false;
  if (mode == runtime::MachineMode::idle) static_cast<void>(machine_.control().line("M72\n"));
}

void Console::leave_alone(bool at_once) {
  journal_.add(EntryKind::action, at_once ? "ended from outside" : "the terminal has gone");
  is_alone_ = true;
  ends_at_once_ = ends_at_once_ || at_once;
  state_.prompt.reset();
  jog_keys_.release();
  requests_.cancel();
  requests_.hold();
}

void Console::wait_alone() {
  const runtime::Operator& control = machine_.control();
  if (control.moving() || control.in_motion()) {
    if (control.mode() == runtime::MachineMode::run) requests_.hold();
    alone_since_.reset();
    return;
  }
  if (!alone_since_) alone_since_ = now_;
  const double alone = ends_at_once_ ? kAtRest : machine_.machine().attendance.alone;
  if (now_ - *alone_since_ < alone) return;
  requests_.reset();
  is_over_ = true;
}

void Console::draw(Screen& screen) const {
  draw_console(screen,
               {state_, machine_, requests_, journal_,
                state_.prompt && state_.prompt->what == Prompt::For::line ? lines_ : answers_});
}

}  // namespace softcnc::app
