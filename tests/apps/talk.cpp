// SPDX-License-Identifier: MIT
#include "apps/talk.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <catch2/catch.hpp>
#include <csignal>
#include <utility>
#include "support/shown.hpp"

namespace softcnc::app::test {

Talk::Talk(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), SOFTCNC_BINARY);
  std::vector<char*> words;
  for (std::string& argument : arguments) words.push_back(argument.data());
  words.push_back(nullptr);
  std::array<int, 2> to{}, from{};
  REQUIRE(::pipe2(to.data(), O_CLOEXEC) == 0);
  REQUIRE(::pipe2(from.data(), O_CLOEXEC) == 0);
  child_ = ::fork();
  REQUIRE(child_ >= 0);
  if (child_ == 0) {
    ::dup2(to[0], STDIN_FILENO);
    ::dup2(from[1], STDOUT_FILENO);
    ::execv(words[0], words.data());
    ::_exit(127);
  }
  ::close(to[0]);
  ::close(from[1]);
  in_ = to[1];
  out_ = from[0];
}

Talk::~Talk() {
  if (in_ >= 0) ::close(in_);
  ::close(out_);
  if (child_ < 0) return;
  ::kill(child_, SIGKILL);
  ::waitpid(child_, nullptr, 0);
}

void Talk::say(const std::string& text) {
  REQUIRE(::write(in_, text.data(), text.size()) == static_cast<ssize_t>(text.size()));
}

bool Talk::read_more() {
  constexpr int kMinute = 60000;  // ms
  pollfd source{out_, POLLIN, 0};
  REQUIRE(::poll(&source, 1, kMinute) > 0);
  std::array<char, 65536> piece{};
  const ssize_t n = ::read(out_, piece.data(), piece.size());
  if (n > 0) heard_.append(piece.data(), static_cast<std::size_t>(n));
  return n > 0;
}

std::string Talk::line() {
  std::size_t end = 0;
  while ((end = heard_.find('\n')) == std::string::npos) REQUIRE(read_more());
  std::string text = heard_.substr(0, end);
  heard_.erase(0, end + 1);
  return text;
}

std::vector<std::string> Talk::hear(const std::string& begin) {
  std::vector<std::string> lines;
  do {
    lines.push_back(line());
  } while (!begins_showing(lines.back(), begin));
  return lines;
}

void Talk::send(int signal) { REQUIRE(::kill(child_, signal) == 0); }

std::string Talk::finish() {
  ::close(std::exchange(in_, -1));
  return hear_rest();
}

std::string Talk::hear_rest() {
  while (read_more()) {
  }
  return std::exchange(heard_, {});
}

int Talk::status() {
  int status = 0;
  ::waitpid(std::exchange(child_, -1), &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace softcnc::app::test
