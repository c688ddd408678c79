// SPDX-License-Identifier: MIT
// `softcnc serve`: a machine for the senders of grbl.
#include <spdlog/spdlog.h>

#include <algorithm>
#include <csignal>

#include "commands/commands.hpp"
#include "messages/messages.hpp"
#include "process/signals.hpp"
#include "process/standard_error.hpp"
#include "serve/clients.hpp"
#include "serve/grbl_control.hpp"

namespace softcnc::app {
namespace {

constexpr double kByteInMotion = 0.002, kByteAtRest = 0.01;  // s to wait for one

/// Returns whether bytes do more than look and stop.
bool commands(std::string_view bytes) noexcept {
  return std::any_of(bytes.begin(), bytes.end(), [](char c) {
    const auto byte = static_cast<RealTime>(static_cast<unsigned char>(c));
    return byte != RealTime::report && byte != RealTime::hold && byte != RealTime::door &&
           byte != RealTime::reset;
  });
}

/// Clients and the control: the first client that commands goes on to, and every one can stop.
class Server {
 public:
  Server(AttendedMachine& machine, GrblControl& control, Clients& clients, StopSignals& signals)
      : machine_(machine), control_(control), clients_(clients), signals_(signals) {}

  /// Returns the exit status.
  int run();

 private:
  void take(const Clients::Event& event);
  void take_beside(int client, const std::string& bytes);

  AttendedMachine& machine_;
  GrblControl& control_;
  Clients& clients_;
  StopSignals& signals_;
  std::optional<int> commands_;  // the client
  bool ends_ = false;
};

void Server::take(const Clients::Event& event) {
  switch (event.kind) {
    case Clients::Event::Kind::connected:
      clients_.send(event.client, GrblControl::banner());
      break;
    case Clients::Event::Kind::gone:
      if (commands_ == event.client) {
        commands_.reset();
        control_.leave_alone();
      }
      break;
    case Clients::Event::Kind::bytes:
      if (!commands_ && commands(event.bytes)) {
        commands_ = event.client;
        control_.come_back();
      }
      if (commands_ == event.client)
        control_.take(event.bytes, session_time());
      else
        take_beside(event.client, event.bytes);
      break;
  }
}

/// A client that does not command sees, and stops.
void Server::take_beside(int client, const std::string& bytes) {
  GrblInput input;
  input.take(bytes, [&](RealTime byte) {
    if (byte == RealTime::report) clients_.send(client, control_.report() + "\r\n");
    if (byte == RealTime::hold || byte == RealTime::door || byte == RealTime::reset)
      control_.act(byte);
    const std::string said = control_.take_output();  // the banner after a reset
    clients_.send(client, said);
    if (commands_) clients_.send(*commands_, said);
  });
  for (; !input.empty(); input.next()) clients_.send(client, "error:8\r\n");
}

int Server::run() {
  int status = 0;
  while (!control_.is_over()) {
    const double patience = machine_.control().in_motion() ? kByteInMotion : kByteAtRest;
    for (const Clients::Event& event : clients_.wait(patience)) take(event);
    if (signals_.poll() != 0 && !std::exchange(ends_, true)) control_.end();
    if (const Status moved = control_.advance(session_time()); !moved)
      status = worse_status(status, exit_status(moved.error()));
    const std::string answers = control_.take_output();
    if (commands_ && !answers.empty()) clients_.send(*commands_, answers);
  }
  return signals_.poll() != 0 ? kSignalled + signals_.poll() : status;
}

/// The program of the command line, which must pass its check.
Result<std::optional<LoadedProgram>> load(const Options& options, const AttendedMachine& machine) {
  if (options.files.empty()) return std::optional<LoadedProgram>();
  auto program = LoadedProgram::open(options.files.front());
  if (!program) return tl::make_unexpected(program.error());
  program->check(machine.machine(), machine.checking_options(), {});
  const CheckedProgram* checked = program->checked();
  if (checked != nullptr) write_to_stderr(checked->found);
  if (checked == nullptr || !checked->passed) return std::optional<LoadedProgram>();
  return std::optional(std::move(*program));
}

}  // namespace

int serve(const Options& asked) {
  Options options = asked;
  options.dialect = ipr::Dialect::grbl;
  StopSignals signals(StopSignals::Later::wait);  // before any thread: they inherit what waits
  Messages messages;
  if (options.link.empty() && options.address.empty())
    return messages.fail({.code = Code::SC6019, .message = "needs --pty LINK or --tcp PORT"});
  Journal journal;
  if (Status opened = journal.open(options.log); !opened) return messages.fail(opened.error());
  GrblControl* hears = nullptr;
  auto machine = AttendedMachine::open(options, messages, [&hears](const Diagnostic& found) {
    if (hears != nullptr) hears->hear(found);
  });
  if (!machine) return messages.fail(machine.error());
  auto program = load(options, **machine);
  if (!program) return messages.fail(program.error());
  if (!options.files.empty() && !*program) return 1;
  auto clients = Clients::open(options.link, options.address);
  if (!clients) return messages.fail(clients.error());
  GrblControl control(**machine, journal, std::move(*program));
  hears = &control;
  signals.begin_motion(moves_machine((*machine)->machine().control.backend));
  spdlog::info("softcnc: serves grbl 1.1 at {}; Ctrl-C ends", (*clients)->places());
  int status = Server(**machine, control, **clients, signals).run();
  for (const Status& finished : {(*machine)->finish(), journal.finish()})
    if (!finished) status = worse_status(status, messages.fail(finished.error()));
  return status;
}

}  // namespace softcnc::app
