// SPDX-License-Identifier: MIT
// What an operator requests of the machine: each request stands in the journal, with its refusal.
#pragma once

#include <string>
#include <string_view>

#include "motion/core/result.hpp"
#include "operate/attended_machine.hpp"
#include "operate/journal.hpp"
#include "operate/loaded_program.hpp"
#include "runtime/operator/jog_move.hpp"
#include "settings/axis_words.hpp"

namespace softcnc::app {

class Requests {
 public:
  struct Overrides {
    double feed = 1, rapid = 1, spindle = 1;
  };
  struct Switches {
    bool single_block = false, optional_stop = false, block_skip = false;
  };

  /// Both must outlive it.
  Requests(AttendedMachine& machine, Journal& journal) : machine_(machine), journal_(journal) {}

  // Each returns whether the machine has taken it.
  bool hold() { return request("hold", &runtime::Operator::hold); }
  bool resume() { return request("go on", &runtime::Operator::resume); }
  bool abort() { return request("abort", &runtime::Operator::abort); }
  bool reset() { return request("reset", &runtime::Operator::reset); }
  bool unlock() { return request("unlock", &runtime::Operator::unlock); }
  bool home() { return request("home", &runtime::Operator::home); }
  bool cancel() { return request("jog ends", &runtime::Operator::cancel); }
  bool jog(const runtime::Jog& jog, const std::string& what);
  bool line(const std::string& text);
  bool start(const LoadedProgram& program);
  bool stand_at(const AxisWords& place, const std::string& text);
  bool touch_off(const AxisWords& place, const std::string& text);
  void estop();

  const Overrides& overrides() const noexcept { return overrides_; }
  void override_feed(double wanted);
  void override_rapid(double wanted);
  void override_spindle(double wanted);

  const Switches& switches() const noexcept { return switches_; }
  void set(const Switches& wanted);

 private:
  runtime::Operator& control() noexcept { return machine_.control(); }
  bool request(std::string_view what, Status (runtime::Operator::*act)());
  void begin(std::string_view what);
  bool end(const Status& answer);

  AttendedMachine& machine_;
  Journal& journal_;
  Overrides overrides_;
  Switches switches_;
};

}  // namespace softcnc::app
