// SPDX-License-Identifier: MIT
#define NCURSES_NOMACROS 1
#include "operate/terminal_window.hpp"

#include <curses.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>

// Of <term.h>, whose macros have the names of everything.
extern "C" int setupterm(const char* name, int descriptor, int* is_known);

namespace softcnc::app {
namespace {

using Clock = std::chrono::steady_clock;

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

void draw_row(const Screen& screen, int row) {
  const std::string& text = screen.text(row);
  for (int begin = 0, end = 0; begin < screen.columns(); begin = end) {
    const Emphasis emphasis = screen.emphasis(row, begin);
    for (end = begin + 1; end < screen.columns() && screen.emphasis(row, end) == emphasis;) ++end;
    ::attrset(static_cast<int>(attributes(emphasis)));
    ::mvaddnstr(row, begin, text.data() + begin, end - begin);
  }
}

void draw(const Screen& screen) {
  if (screen.rows() != getmaxy(stdscr) || screen.columns() != getmaxx(stdscr)) {
    ::resizeterm(screen.rows(), screen.columns());
    ::clear();
  }
  ::curs_set(screen.cursor() ? 1 : 0);
  for (int row = 0; row < screen.rows(); ++row) draw_row(screen, row);
  if (const auto cursor = screen.cursor()) ::move(cursor->first, cursor->second);
  ::refresh();
}

}  // namespace

/// Alone in using ncurses: a write to the terminal may never return.
class TerminalWindow::Picture {
 public:
  static void begin(const std::shared_ptr<Picture>& picture) {
    std::thread([picture] { picture->run(); }).detach();
  }

  void show(Screen screen) {
    const std::lock_guard lock(mutex_);
    if (next_) return;
    next_ = std::move(screen);
    changed_.notify_all();
  }

  /// How long the picture that is drawn now has taken, s.
  double stalled() {
    const std::lock_guard lock(mutex_);
    return is_drawing_ ? std::chrono::duration<double>(Clock::now() - since_).count() : 0;
  }

  /// Ends ncurses; gives up where the terminal takes nothing.
  void end() {
    std::unique_lock lock(mutex_);
    ends_ = true;
    changed_.notify_all();
    changed_.wait_for(lock, std::chrono::milliseconds(500), [this] { return ended_; });
  }

 private:
  void run() {
    std::unique_lock lock(mutex_);
    while (true) {
      changed_.wait(lock, [this] { return ends_ || next_; });
      if (ends_) break;
      const Screen screen = *std::exchange(next_, std::nullopt);
      is_drawing_ = true;
      since_ = Clock::now();
      lock.unlock();
      draw(screen);
      lock.lock();
      is_drawing_ = false;
    }
    ::endwin();
    ended_ = true;
    changed_.notify_all();
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<Screen> next_;
  bool is_drawing_ = false, ends_ = false, ended_ = false;
  Clock::time_point since_;
};

TerminalWindow::TerminalWindow(std::shared_ptr<Picture> picture) : picture_(std::move(picture)) {
  Picture::begin(picture_);
}

Result<std::unique_ptr<TerminalWindow>> TerminalWindow::open() {
  const auto refused = [](const char* why) {
    return tl::make_unexpected(Diagnostic{.code = Code::SC6018, .message = why});
  };
  if (::isatty(STDIN_FILENO) == 0 || ::isatty(STDOUT_FILENO) == 0)
    return refused("standard input and output are not both a terminal");
  termios before{};
  ::tcgetattr(STDIN_FILENO, &before);
  int is_known = 0;
  if (::setupterm(nullptr, STDOUT_FILENO, &is_known) != OK ||
      ::newterm(nullptr, stdout, stdin) == nullptr)
    return refused("the terminal is not known by its name in TERM");
  ::raw();
  ::noecho();
  ::nonl();
  std::unique_ptr<TerminalWindow> window(new TerminalWindow(std::make_shared<Picture>()));
  window->before_ = before;
  return window;
}

TerminalWindow::~TerminalWindow() {
  picture_->end();
  ::tcsetattr(STDIN_FILENO, TCSANOW, &before_);
}

std::vector<Key> TerminalWindow::keys(double now) {
  std::vector<Key> keys;
  std::array<char, 256> bytes;
  for (pollfd input{STDIN_FILENO, POLLIN, 0}; ::poll(&input, 1, 0) > 0;) {
    const ssize_t size = ::read(STDIN_FILENO, bytes.data(), bytes.size());
    ended_ = ended_ || size <= 0;
    if (size <= 0) break;
    const auto more = decoder_.take({bytes.data(), static_cast<std::size_t>(size)}, now);
    keys.insert(keys.end(), more.begin(), more.end());
  }
  if (const auto escape = decoder_.wait(now)) keys.push_back(*escape);
  return keys;
}

bool TerminalWindow::wait(double seconds) {
  pollfd input{STDIN_FILENO, POLLIN, 0};
  ::poll(&input, 1, static_cast<int>(std::ceil(1000 * seconds)));
  const bool is_gone = ended_ || (input.revents & (POLLHUP | POLLERR | POLLNVAL)) != 0;
  return !is_gone && picture_->stalled() < kMostStalled;
}

Screen TerminalWindow::blank() const {
  winsize size{};
  const bool is_known = ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_row > 0;
  return is_known ? Screen(size.ws_row, size.ws_col) : Screen(24, 80);
}

void TerminalWindow::show(Screen screen) { picture_->show(std::move(screen)); }

}  // namespace softcnc::app
