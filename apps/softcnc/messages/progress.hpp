// SPDX-License-Identifier: MIT
// The progress of a run, for a person or a program that reads standard error.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace softcnc::app {

enum class ProgressMode : std::uint8_t { automatic, none, json };

/// Redraws at most ten times a second; JSON ends with one more object. The clock drives the display
/// and nothing else.
class Progress {
 public:
  /// `data_on_terminal`: rows appear on the same screen, so there is no place for a bar.
  Progress(ProgressMode mode, bool data_on_terminal);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Begins a part of the work; `total` in s of machine time, 0: unknown.
  void begin(std::string label, double total);

  /// `time` in s of machine time.
  void update(double time, int line);

  /// Takes the bar off the screen.
  void clear();

 private:
  void draw(double time, int line);
  void write_json(bool done) const;

  using Clock = std::chrono::steady_clock;
  bool bar_, json_;
  bool drawn_ = false;
  std::string label_;
  double total_ = 0, time_ = 0;
  int line_ = 0;
  Clock::time_point next_{};
};

}  // namespace softcnc::app
