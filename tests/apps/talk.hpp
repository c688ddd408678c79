// SPDX-License-Identifier: MIT
// A conversation with the program over pipes: what is said next may depend on what was heard.
#pragma once

#include <string>
#include <vector>

namespace softcnc::app::test {

class Talk {
 public:
  /// Starts softcnc with these arguments.
  explicit Talk(std::vector<std::string> arguments);
  Talk(const Talk&) = delete;
  Talk& operator=(const Talk&) = delete;
  ~Talk();

  void say(const std::string& text);
  /// Waits for a line that begins so, and returns all lines up to it; fails after a minute.
  std::vector<std::string> hear(const std::string& begin);
  void send(int signal);
  /// Ends its input, and returns what is left of its output.
  std::string finish();
  /// What is left of its output when it ends by itself.
  std::string hear_rest();
  /// The exit status, as a shell reports it.
  int status();

 private:
  std::string line();
  bool read_more();

  int child_ = -1, in_ = -1, out_ = -1;
  std::string heard_;
};

}  // namespace softcnc::app::test
