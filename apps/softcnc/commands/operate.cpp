// SPDX-License-Identifier: MIT
// `softcnc operate`: a person at the machine, in a terminal.
#include <csignal>

#include "commands/commands.hpp"
#include "messages/messages.hpp"
#include "motion/core/units.hpp"
#include "operate/console.hpp"
#include "operate/terminal_window.hpp"
#include "process/signals.hpp"
#include "runtime/realtime/realtime.hpp"

namespace softcnc::app {
namespace {

constexpr double kFrame = 0.1;                         // s from one picture to the next
constexpr double kWaitInMotion = 0.005, kWait = 0.02;  // s for a key

/// Returns the time since it was asked for first, s.
double now() {
  static const std::int64_t begin = runtime::now_ns();
  return s_from_ns(static_cast<double>(runtime::now_ns() - begin));
}

/// The console in its terminal, until the operator quits or is gone.
class Session {
 public:
  Session(AttendedMachine& machine, Journal& journal, TerminalWindow& window)
      : machine_(machine),
        window_(window),
        console_(machine, journal, [this] { return ends_check(); }) {
    signals_.begin_motion(moves_machine(machine.machine().control.backend));
  }

  /// Returns the exit status.
  int run(const std::string& part);

 private:
  void take_keys();
  void draw();
  void leave(int signal);
  bool ends_check();

  AttendedMachine& machine_;
  TerminalWindow& window_;
  StopSignals signals_;
  Console console_;
  double drawn_ = -kFrame;  // s
  int left_by_ = 0;   // signal
};

/// All that have come by now are of one instant.
void Session::take_keys() {
  const double instant = now();
  while (const auto key = window_.next_key()) {
    console_.key(*key, instant);
    drawn_ = -kFrame;
  }
}

void Session::draw() {
  if (now() - drawn_ < kFrame) return;
  Screen screen = window_.blank();
  console_.draw(screen);
  window_.show(screen);
  drawn_ = now();
}

void Session::leave(int signal) {
  left_by_ = signal;
  console_.leave_alone(signal != SIGHUP);
}

bool Session::ends_check() {
  if (signals_.poll() != 0) return true;
  if (now() - drawn_ < kFrame) return false;
  Screen screen = window_.blank();
  console_.draw(screen);
  screen.put_row(screen.rows() - 1, " checking the program: Esc ends it", Emphasis::reverse);
  window_.show(screen);
  drawn_ = now();
  while (const auto key = window_.next_key())
    if (key->kind == Key::Kind::escape || key->kind == Key::Kind::interrupt) return true;
  return false;
}

int Session::run(const std::string& part) {
  int status = 0;
  if (!part.empty()) console_.load(part);
  while (!console_.is_over()) {
    if (left_by_ == 0) take_keys();
    if (const int signal = signals_.poll(); signal != 0 && left_by_ == 0) leave(signal);
    if (const Status moved = console_.advance(now()); !moved)
      status = worse_status(status, exit_status(moved.error()));
    const double patience = machine_.control().in_motion() ? kWaitInMotion : kWait;
    if (left_by_ != 0) {
      runtime::sleep_until(runtime::now_ns() + static_cast<std::int64_t>(ns_from_s(patience)));
      continue;
    }
    draw();
    if (!window_.wait(patience)) leave(SIGHUP);
  }
  return left_by_ != 0 ? kSignalled + left_by_ : status;
}

}  // namespace

int operate(const Options& options) {
  Messages messages;
  Journal journal;
  if (Status opened = journal.open(options.log); !opened) return messages.fail(opened.error());
  std::unique_ptr<AttendedMachine> machine;
  auto opened = AttendedMachine::open(options, messages, [&](const Diagnostic& found) {
    journal.add(found, machine != nullptr && machine->control().in_program());
  });
  if (!opened) return messages.fail(opened.error());
  machine = std::move(*opened);
  int status = 0;
  {
    auto window = TerminalWindow::open();
    if (!window) return messages.fail(window.error());
    status = Session(*machine, journal, **window)
                 .run(options.files.empty() ? "" : options.files.front());
  }
  if (const Status finished = machine->finish(); !finished)
    status = worse_status(status, messages.fail(finished.error()));
  if (const Status finished = journal.finish(); !finished)
    status = worse_status(status, messages.fail(finished.error()));
  return status;
}

}  // namespace softcnc::app
