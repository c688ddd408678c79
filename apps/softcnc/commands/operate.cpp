// SPDX-License-Identifier: MIT
// `softcnc operate`: a person at the machine, in a terminal.
#include <csignal>
#include <utility>
#include <vector>

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

/// The console in its terminal, until the operator quits or is gone.
class Attendant {
 public:
  Attendant(AttendedMachine& machine, Journal& journal, TerminalWindow& window,
            StopSignals& signals)
      : machine_(machine),
        window_(window),
        signals_(signals),
        console_(machine, journal, [this] { return ends_check(); }) {}

  /// Returns the exit status.
  int run(const std::string& part);

 private:
  void take_keys();
  void take_signals();
  void draw(const char* instead_of_keys = nullptr);
  void leave(int signal);
  bool ends_check();

  AttendedMachine& machine_;
  TerminalWindow& window_;
  StopSignals& signals_;
  Console console_;
  std::vector<Key> kept_;   // of a check, that it has ended by
  double drawn_ = -kFrame;  // s
  int left_by_ = 0;         // signal
};

/// All that have come by now are of one instant.
void Attendant::take_keys() {
  const double instant = session_time();
  std::vector<Key> keys = std::exchange(kept_, {});
  const std::vector<Key> more = window_.keys(instant);
  keys.insert(keys.end(), more.begin(), more.end());
  for (const Key& key : keys) console_.key(key, instant);
  if (!keys.empty()) drawn_ = -kFrame;
}

void Attendant::draw(const char* instead_of_keys) {
  if (session_time() - drawn_ < kFrame) return;
  Screen screen = window_.blank();
  console_.draw(screen);
  if (instead_of_keys != nullptr)
    screen.put_row(screen.rows() - 1, instead_of_keys, Emphasis::reverse);
  window_.show(std::move(screen));
  drawn_ = session_time();
}

/// Whoever sends a signal after a hang-up does not want to wait.
void Attendant::take_signals() {
  const int signal = signals_.poll();
  if (signal != 0 && left_by_ == 0) leave(signal);
  if (const int later = signals_.poll_later(); later != 0 && later != SIGHUP) leave(later);
}

void Attendant::leave(int signal) {
  left_by_ = left_by_ == 0 ? signal : left_by_;
  console_.leave_alone(signal != SIGHUP);
}

/// Keys that stop end a check, and then do what they always do.
bool Attendant::ends_check() {
  draw(" checking the program: Esc ends it");
  for (const Key& key : window_.keys(session_time()))
    if (key.kind == Key::Kind::escape || key.kind == Key::Kind::interrupt || key == key_of('e') ||
        key == key_of(' '))
      kept_.push_back(key);
  return signals_.poll() != 0 || !kept_.empty();
}

int Attendant::run(const std::string& part) {
  int status = 0;
  if (!part.empty()) console_.load(part);
  while (!console_.is_over()) {
    if (left_by_ == 0) take_keys();
    take_signals();
    if (const Status moved = console_.advance(session_time()); !moved)
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
  StopSignals signals(StopSignals::Later::wait);  // before any thread: they inherit what waits
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
    signals.begin_motion(moves_machine(machine->machine().control.backend));
    status = Attendant(*machine, journal, **window, signals)
                 .run(options.files.empty() ? "" : options.files.front());
  }
  for (const Status& finished : {machine->finish(), journal.finish()})
    if (!finished) status = worse_status(status, messages.fail(finished.error()));
  return status;
}

}  // namespace softcnc::app
