// SPDX-License-Identifier: MIT
// A machine with its operator behind the protocol of grbl 1.1.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "operate/attended_machine.hpp"
#include "operate/journal.hpp"
#include "operate/loaded_program.hpp"
#include "operate/requests.hpp"
#include "serve/grbl_input.hpp"
#include "serve/grbl_report.hpp"
#include "serve/grbl_words.hpp"

namespace softcnc::app {

/// Bytes in, answers out. Each line gets one answer, in the order of the lines; real-time bytes act
/// at once. It has no clock and no connection of its own: instants are those of the calls, in s.
class GrblControl {
 public:
  /// Both must outlive it. `program`, which has passed its check, begins with `~` in Idle.
  GrblControl(AttendedMachine& machine, Journal& journal,
              std::optional<LoadedProgram> program = {});

  /// What is wrong with lines comes here, from the machine.
  void hear(const Diagnostic& found);
  /// Takes bytes of the client that commands.
  void take(std::string_view bytes, double now);
  /// Does what a real-time byte requests; a report goes to the output.
  void act(RealTime byte);
  /// Moves on to `now`. Errors: those of AttendedMachine::advance(); the machine is held then.
  Status advance(double now);
  /// Returns what is to be sent, and forgets it.
  std::string take_output();
  /// Returns a status report.
  std::string report() { return reports_.status(machine_, requests_, shown_state()); }

  /// The client that commands has gone: a jog ends, and a job is held or, by
  /// serve.on_disconnect, goes on.
  void leave_alone();
  /// Somebody commands again.
  void come_back() noexcept { alone_since_.reset(); }
  /// Comes to rest, and ends once the machine rests.
  void end();
  bool is_over() const noexcept { return is_over_; }

  /// The banner of grbl, for a client that connects.
  static std::string banner();

 private:
  static constexpr const char* kUnlockMessage = "[MSG:'$H'|'$X' to unlock]";

  /// What the answer to a line waits for.
  enum class Wait : std::uint8_t { nothing, rest, homed, fewer_blocks, recovery };

  std::string shown_state() const;
  bool is_locked() const noexcept;
  void read_on();
  bool may_read();
  void answer(const GrblInput::Line& line);
  void run(const std::string& line);
  void refuse_line();
  void miss();
  void begin_modes();
  void jog(std::string_view words);
  std::optional<runtime::Jog> jog_of(const std::vector<GrblWord>& words, int& error) const;
  void dollar(const std::string& line);
  void set(std::string_view number, std::string_view value);
  void unlock();
  void home();
  void say(std::string_view text);
  void say_error(int error);
  void refuse(const Diagnostic& why);
  void end_wait();
  void reset();
  void stop();
  bool check_program();
  void hold();
  void resume();
  void begin_again();
  void watch_alarm();
  void wait_alone();

  AttendedMachine& machine_;
  Journal& journal_;
  Requests requests_;
  std::optional<LoadedProgram> program_;
  GrblInput input_;
  GrblReports reports_;
  std::string output_;
  double now_ = 0;  // s
  Wait wait_ = Wait::nothing;
  std::vector<GrblWord> waiting_;  // the words of the line that waits
  std::vector<Diagnostic> found_;  // of the present line
  bool locked_ = false;            // nobody has said where the machine is
  bool resetting_ = false;         // until it rests
  bool was_alarm_ = false;
  std::optional<double> alone_since_;  // s
  bool ends_ = false, is_over_ = false;
};

}  // namespace softcnc::app
