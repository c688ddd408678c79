// SPDX-License-Identifier: MIT
// The terminal as a screen and a keyboard: ncurses draws, in a thread of its own.
#pragma once

#include <termios.h>

#include <memory>
#include <vector>

#include "motion/core/result.hpp"
#include "operate/key.hpp"
#include "operate/key_decoder.hpp"
#include "operate/screen.hpp"

namespace softcnc::app {

/// The terminal of standard input and output, which is as before once this is gone. There can be
/// one. A terminal that takes no more bytes, as of a connection that stands still, holds up nothing
/// but its picture.
class TerminalWindow {
 public:
  /// Errors: SC6018 where there is no terminal, or one that ncurses does not know.
  static Result<std::unique_ptr<TerminalWindow>> open();
  TerminalWindow(const TerminalWindow&) = delete;
  TerminalWindow& operator=(const TerminalWindow&) = delete;
  ~TerminalWindow();

  /// Returns the keys that have been pressed by now, s.
  std::vector<Key> keys(double now);
  /// Waits for a key, at most `seconds`. Returns false once the terminal has gone, or has taken no
  /// picture for kMostStalled.
  bool wait(double seconds);

  /// Returns a blank screen of the present size.
  Screen blank() const;
  /// Shows a screen, unless the terminal is still busy with the one before.
  void show(Screen screen);

 private:
  class Picture;

  static constexpr double kMostStalled = 10;  // s

  explicit TerminalWindow(std::shared_ptr<Picture> picture);

  std::shared_ptr<Picture> picture_;
  KeyDecoder decoder_;
  termios before_{};
  bool ended_ = false;  // there is no more to read
};

}  // namespace softcnc::app
