// SPDX-License-Identifier: MIT
// The program from outside: what it is given, and what comes back.
#pragma once

#include <string>
#include <vector>

#include "support/shown.hpp"

namespace softcnc::app::test {

using softcnc::begins_showing;
using softcnc::shows;
using softcnc::where_shown;

struct Ended {
  int status = 0;  // as a shell reports it: 128 + n for signal n
  std::string out, err;
};

/// Runs a shell command in which $softcnc, $data and $programs stand for the program, for
/// tests/apps/data and for programs/; what it reads from standard input is `input`.
Ended shell(const std::string& command, const std::string& input = {});

/// The same for one call of softcnc with these arguments.
inline Ended call(const std::string& arguments, const std::string& input = {}) {
  return shell("$softcnc " + arguments, input);
}

/// A shell command on a terminal of its own: what the test reads, writes and closes, and the
/// process.
struct OwnTerminal {
  int terminal = -1, child = -1;
};
OwnTerminal start_on_terminal(const std::string& command);

/// An answer that closes the terminal at the first prompt.
inline const std::string kHangUp;

/// Runs a shell command on a terminal of its own; answers each prompt.
Ended on_terminal(const std::string& command, const std::string& answer = "\n");

/// A new empty folder, removed with all it holds.
class Folder {
 public:
  Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder();

  std::string operator/(const std::string& name) const { return path_ + '/' + name; }
  std::vector<std::string> files() const;

 private:
  std::string path_;
};

std::string read(const std::string& file);
void write(const std::string& file, const std::string& text);
std::string data(const std::string& name);

/// A trace as it stands in a CSV file.
struct Trace {
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;

  double number(std::size_t row, const std::string& column) const;
  std::string word(std::size_t row, const std::string& column) const;
};
Trace parse_trace(const std::string& text);

}  // namespace softcnc::app::test
