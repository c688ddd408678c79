// SPDX-License-Identifier: MIT
#define NCURSES_NOMACROS 1
#include "operate/terminal_window.hpp"

#include <curses.h>
#include <poll.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <string>

namespace softcnc::app {
namespace {

constexpr int kEscapeDelay = 25;  // ms: the bytes of one key come within
constexpr int kControlC = 3, kBackspace = 8, kEscape = 27, kDelete = 127;

Key key_of_code(int code) noexcept {
  using Kind = Key::Kind;
  switch (code) {
    case KEY_UP:
      return {Kind::up};
    case KEY_DOWN:
      return {Kind::down};
    case KEY_LEFT:
      return {Kind::left};
    case KEY_RIGHT:
      return {Kind::right};
    case KEY_PPAGE:
      return {Kind::page_up};
    case KEY_NPAGE:
      return {Kind::page_down};
    case KEY_HOME:
      return {Kind::home};
    case KEY_END:
      return {Kind::end};
    case KEY_DC:
      return {Kind::delete_};
    case KEY_BACKSPACE:
    case kBackspace:
    case kDelete:
      return {Kind::backspace};
    case KEY_ENTER:
    case '\r':
    case '\n':
      return {Kind::enter};
    case kEscape:
      return {Kind::escape};
    case kControlC:
      return {Kind::interrupt};
    default:
      return code >= ' ' && code < kDelete ? key_of(static_cast<char>(code)) : Key{};
  }
}

attr_t attributes(Emphasis emphasis) noexcept {
  switch (emphasis) {
    case Emphasis::bold:
      return A_BOLD;
    case Emphasis::reverse:
      return A_REVERSE;
    default:
      return A_NORMAL;
  }
}

void show_row(const Screen& screen, int row) {
  const std::string& text = screen.text(row);
  for (int begin = 0, end = 0; begin < screen.columns(); begin = end) {
    const Emphasis emphasis = screen.emphasis(row, begin);
    for (end = begin + 1; end < screen.columns() && screen.emphasis(row, end) == emphasis;) ++end;
    ::attrset(static_cast<int>(attributes(emphasis)));
    ::mvaddnstr(row, begin, text.data() + begin, end - begin);
  }
}

}  // namespace

Result<std::unique_ptr<TerminalWindow>> TerminalWindow::open() {
  const auto refused = [](const char* why) {
    return tl::make_unexpected(Diagnostic{.code = Code::SC6018, .message = why});
  };
  if (::isatty(STDIN_FILENO) == 0 || ::isatty(STDOUT_FILENO) == 0)
    return refused("standard input and output are not both a terminal");
  if (::newterm(nullptr, stdout, stdin) == nullptr)
    return refused("the terminal is not known by its name in TERM");
  ::raw();
  ::noecho();
  ::nonl();
  ::keypad(stdscr, true);
  ::nodelay(stdscr, true);
  ::set_escdelay(kEscapeDelay);
  return std::unique_ptr<TerminalWindow>(new TerminalWindow);
}

TerminalWindow::~TerminalWindow() { ::endwin(); }

std::optional<Key> TerminalWindow::next_key() {
  const int code = ::getch();
  if (code == ERR) return std::nullopt;
  return key_of_code(code);
}

bool TerminalWindow::wait(double seconds) {
  pollfd input{STDIN_FILENO, POLLIN, 0};
  ::poll(&input, 1, static_cast<int>(std::ceil(1000 * seconds)));
  return (input.revents & (POLLHUP | POLLERR | POLLNVAL)) == 0;
}

Screen TerminalWindow::blank() const { return {getmaxy(stdscr), getmaxx(stdscr)}; }

void TerminalWindow::show(const Screen& screen) {
  ::curs_set(screen.cursor() ? 1 : 0);
  for (int row = 0; row < screen.rows(); ++row) show_row(screen, row);
  if (const auto cursor = screen.cursor()) ::move(cursor->first, cursor->second);
  ::refresh();
}

}  // namespace softcnc::app
