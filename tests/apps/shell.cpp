// SPDX-License-Identifier: MIT
#include "apps/shell.hpp"

#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

namespace softcnc::app::test {
namespace {

std::string quoted(const std::string& text) { return '\'' + text + '\''; }

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> values;
  std::istringstream stream(line);
  for (std::string value; std::getline(stream, value, ',');) values.push_back(value);
  return values;
}

}  // namespace

Ended shell(const std::string& command, const std::string& input) {
  const Folder folder;
  write(folder / "in", input);
  const std::string set_up = "softcnc=" SOFTCNC_BINARY " data=" SOFTCNC_SOURCE_DIR
                             "/tests/apps/data programs=" SOFTCNC_SOURCE_DIR "/programs; ";
  write(folder / "command", set_up + command);
  const std::string line = "sh " + quoted(folder / "command") + " <" + quoted(folder / "in") +
                           " >" + quoted(folder / "out") + " 2>" + quoted(folder / "err");
  const int result = std::system(line.c_str());
  REQUIRE(WIFEXITED(result));
  return {WEXITSTATUS(result), read(folder / "out"), read(folder / "err")};
}

Folder::Folder() {
  std::string name = (std::filesystem::temp_directory_path() / "softcnc_test_XXXXXX").string();
  REQUIRE(::mkdtemp(name.data()) != nullptr);
  path_ = name;
}

Folder::~Folder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::vector<std::string> Folder::files() const {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(path_))
    names.push_back(entry.path().filename());
  std::sort(names.begin(), names.end());
  return names;
}

std::string read(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  REQUIRE(stream);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void write(const std::string& file, const std::string& text) {
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  stream.close();
  REQUIRE(stream);
}

std::string data(const std::string& name) {
  return std::string(SOFTCNC_SOURCE_DIR "/tests/apps/data/") + name;
}

double Trace::number(std::size_t row, const std::string& column) const {
  return std::stod(word(row, column));
}

std::string Trace::word(std::size_t row, const std::string& column) const {
  const auto found = std::find(columns.begin(), columns.end(), column);
  REQUIRE(found != columns.end());
  return rows.at(row).at(static_cast<std::size_t>(found - columns.begin()));
}

Trace parse_trace(const std::string& text) {
  Trace trace;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with('#')) continue;
    if (trace.columns.empty())
      trace.columns = split(line);
    else
      trace.rows.push_back(split(line));
  }
  return trace;
}

OwnTerminal start_on_terminal(const std::string& command) {
  OwnTerminal started;
  started.child = ::forkpty(&started.terminal, nullptr, nullptr, nullptr);
  REQUIRE(started.child >= 0);
  if (started.child == 0) {
    ::execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
    ::_exit(127);
  }
  return started;
}

Ended on_terminal(const std::string& command, const std::string& answer) {
  const auto [terminal, child] = start_on_terminal(command);
  Ended ended;
  std::array<char, 4096> piece{};
  const std::string prompt = "press Enter ";
  for (ssize_t n = 0; (n = ::read(terminal, piece.data(), piece.size())) > 0;) {
    ended.out.append(piece.data(), static_cast<std::size_t>(n));
    if (!ended.out.ends_with(prompt)) continue;
    if (answer == kHangUp) break;
    CHECK(::write(terminal, answer.data(), answer.size()) == static_cast<ssize_t>(answer.size()));
  }
  if (answer == kHangUp) ::close(terminal);
  int status = 0;
  ::waitpid(child, &status, 0);
  if (answer != kHangUp) ::close(terminal);
  ended.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return ended;
}

}  // namespace softcnc::app::test
