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
  /// `part` of the program has been read, from 0 to 1: how far the work is if its total is unknown.
  void read(double part);

  /// From here on machine time is that of the clock, pauses apart.
  void keep_the_clock() noexcept { real_time_ = true; }

  /// Takes the bar off the screen.
  void clear();

 private:
  void show();
  void draw();
  double part() const noexcept;
  double time_left() const;
  void write_json(bool done) const;

  using Clock = std::chrono::steady_clock;
  bool bar_, json_;
  bool drawn_ = false, real_time_ = false;
  std::string label_;
  double total_ = 0, time_ = 0, read_ = 0;
  int line_ = 0;
  Clock::time_point begun_{}, next_{};
};

}  // namespace softcnc::app
