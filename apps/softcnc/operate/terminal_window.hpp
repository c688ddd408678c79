// SPDX-License-Identifier: MIT
// The terminal as a screen and a keyboard, by ncurses.
#pragma once

#include <memory>
#include <optional>

#include "motion/core/result.hpp"
#include "operate/key.hpp"
#include "operate/screen.hpp"

namespace softcnc::app {

/// The terminal of standard input and output, which is as before once this is gone. There can be
/// one.
class TerminalWindow {
 public:
  /// Errors: SC6018 where there is no terminal, or one that ncurses does not know.
  static Result<std::unique_ptr<TerminalWindow>> open();
  TerminalWindow(const TerminalWindow&) = delete;
  TerminalWindow& operator=(const TerminalWindow&) = delete;
  ~TerminalWindow();

  /// Returns a key that has been pressed; nothing if none has.
  std::optional<Key> next_key();
  /// Waits for a key, at most `seconds`. Returns false once the terminal has gone.
  bool wait(double seconds);

  /// Returns a blank screen of the present size.
  Screen blank() const;
  void show(const Screen& screen);

 private:
  TerminalWindow() = default;
};

}  // namespace softcnc::app
