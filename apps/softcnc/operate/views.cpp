// SPDX-License-Identifier: MIT
#include "operate/views.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "operate/console.hpp"

namespace softcnc::app {
namespace {

constexpr int kNews = 3;          // rows
constexpr int kLeastProgram = 3;  // rows: fewer show nothing of the lines around

std::string coordinate(double mm) {
  constexpr double kHalfDigit = 0.0005;
  return fmt::format("{:12.3f}", std::abs(mm) < kHalfDigit ? 0.0 : mm);
}

std::string title(const ConsoleView& view) {
  const runtime::Operator& control = view.machine.control();
  const auto mode = runtime::kModeNames[static_cast<std::size_t>(control.mode())];
  return fmt::format(" {:<6} {:<28} {}", mode,
                     view.state.program ? view.state.program->name() : "no program",
                     view.machine.machine().name);
}

void draw_axes(Screen& screen, int first, int end, const ConsoleView& view) {
  const runtime::Operator& control = view.machine.control();
  const AxisVector& place = control.position();
  const AxisVector work = control.programmed(place), to_go = control.to_go();
  const bool is_headed = end - first > kAxes;
  if (is_headed)
    screen.put(first, 0,
               fmt::format("   {:>12}{:>12}{:>12}",
                           work_system_name(static_cast<std::size_t>(control.state().active)),
                           control.knows_position() ? "machine" : "machine ?", "to go"));
  for (int axis = 0; axis < kAxes; ++axis) {
    const int row = first + axis + (is_headed ? 1 : 0);
    if (row >= end || !view.machine.machine().axes[static_cast<std::size_t>(axis)].present)
      continue;
    screen.put(
        row, 0,
        fmt::format(" {} {}", kAxisLetters[static_cast<std::size_t>(axis)], coordinate(work[axis])),
        Emphasis::bold);
    screen.put(row, 15, coordinate(place[axis]) + coordinate(to_go[axis]));
  }
}

std::string without_tabs(std::string_view line) {
  std::string text(line);
  std::replace(text.begin(), text.end(), '\t', ' ');
  return text;
}

/// The lines around the one that runs.
void draw_program(Screen& screen, int first, int end, const ConsoleView& view) {
  const int rows = end - first;
  if (!view.state.program || rows <= 0) return;
  const int present = view.state.runs ? view.state.line : 0;
  const int top =
      std::clamp(present - rows / 2, 1, std::max(view.state.program->lines() - rows + 1, 1));
  for (int i = 0; i < rows && top + i <= view.state.program->lines(); ++i) {
    const int line = top + i;
    screen.put(first + i, 0,
               fmt::format("{}{:6}  {}", line == present ? '>' : ' ', line,
                           without_tabs(view.state.program->line(line))),
               line == present ? Emphasis::bold : Emphasis::none);
  }
}

void draw_news(Screen& screen, int first, int end, const Journal& journal) {
  const auto& news = journal.news();
  const std::size_t rows = static_cast<std::size_t>(std::max(end - first, 0));
  const std::size_t from = news.size() - std::min(news.size(), rows);
  for (std::size_t i = from; i < news.size(); ++i)
    screen.put(first + static_cast<int>(i - from), 0, ' ' + news[i].text,
               news[i].kind == EntryKind::fault ? Emphasis::bold : Emphasis::none);
}

/// What is typed; else the keys of the page.
void draw_last_row(Screen& screen, const ConsoleView& view) {
  const int row = screen.rows() - 1;
  if (view.state.prompt) {
    const std::string& label = view.state.prompt->label;
    const auto width = static_cast<std::size_t>(std::max(screen.columns() - 1, 1));
    const std::size_t cursor = label.size() + view.editor.cursor();
    const std::size_t hidden = cursor >= width ? cursor - width + 1 : 0;
    const std::string text = label + view.editor.text();
    screen.put(row, 0, std::string_view(text).substr(std::min(hidden, text.size())));
    return screen.set_cursor(row, static_cast<int>(cursor - hidden));
  }
  const std::string_view keys =
      view.state.page == Page::main
          ? " space hold  Enter go on  s start  h home  m line  l load  t touch off  ? keys"
      : view.state.page == Page::work ? " up, down  Enter origin  a make active  q back"
      : view.state.page == Page::tools
          ? " up, down  Enter offset  m measure  g get into the spindle  q back"
          : " up, down  q back";
  screen.put_row(row, keys, Emphasis::reverse);
}

/// Rows from the top: axes, advice, feed and program, lines; above the last row what has happened.
void draw_main(Screen& screen, int first, int end, const ConsoleView& view) {
  const auto status = status_rows(view);
  int row = first;
  const int axes = std::min(end - row, kAxes + (end - row > kAxes + 4 ? 1 : 0));
  draw_axes(screen, row, row + axes, view);
  row += axes;
  const std::string hint = advice(view);
  if (row < end && !hint.empty()) screen.put(end - 1, 0, ' ' + hint, Emphasis::bold);
  int below = end - (row < end && !hint.empty() ? 1 : 0);
  const int news = std::min({kNews, below - row, static_cast<int>(view.journal.news().size())});
  draw_news(screen, below - news, below, view.journal);
  below -= news;
  const int spare = below - row - static_cast<int>(status.size());
  if (spare > kLeastProgram + 1) ++row;  // a blank row
  for (const std::string& text : status)
    if (row < below) screen.put(row++, 0, text);
  if (spare > kLeastProgram + 2) ++row;
  if (below - row >= kLeastProgram) draw_program(screen, row, below, view);
}

}  // namespace

void draw_console(Screen& screen, const ConsoleView& view) {
  screen.put_row(0, title(view), Emphasis::reverse);
  const int end = screen.rows() - 1;
  switch (view.state.page) {
    case Page::main:
      draw_main(screen, 1, end, view);
      break;
    case Page::keys:
      draw_keys(screen, 1, end);
      break;
    case Page::work:
      draw_work(screen, 1, end, view);
      break;
    case Page::tools:
      draw_tools(screen, 1, end, view);
      break;
    case Page::found:
      draw_found(screen, 1, end, view);
      break;
  }
  if (end > 0) draw_last_row(screen, view);
}

}  // namespace softcnc::app
