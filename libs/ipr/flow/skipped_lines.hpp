// SPDX-License-Identifier: MIT
// The lines of a text that have been passed over and never read.
#pragma once

#include <cstddef>
#include <deque>
#include <utility>

#include "ipr/text/reader.hpp"

namespace softcnc::ipr {

class SkippedLines {
 public:
  /// Lines after a place, up to this one; never empty.
  struct Stretch {
    Reader::Place begin;
    int last = 0;
  };
  static constexpr std::size_t kMost = 10'000;  // stretches; more are not kept

  /// This line has been read, and the reader stands after it. `moved`: it is not the next one
  /// after the line read before.
  void read(int line, const Reader::Place& after, bool moved);
  int last_read() const noexcept { return last_read_; }

  /// In the order of the text; none are left. `rest`: after them what follows all lines read.
  std::deque<Stretch> take(bool rest);

 private:
  void cut_out(int first, int line, const Reader::Place& after);

  int last_read_ = 0;
  Reader::Place known_;  // lines before it have been read, or are in a stretch
  std::deque<Stretch> stretches_;
};

}  // namespace softcnc::ipr
