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
  /// The lines after a place, up to and including line `last`; never empty.
  struct Stretch {
    Reader::Place begin;
    int last = 0;
  };
  static constexpr std::size_t kMost = 10'000;  // stretches; more are not kept

  /// Records that this line has been read; the reader stands after it. `moved` says that it is not
  /// the one after the line read before.
  void read(int line, const Reader::Place& after, bool moved);
  int last_read() const noexcept { return last_read_; }

  /// Returns all stretches in the order of the text, and forgets them. With `rest`, what follows
  /// all lines read is the last one.
  std::deque<Stretch> take(bool rest);

 private:
  void cut_out(int first, int line, const Reader::Place& after);

  int last_read_ = 0;
  Reader::Place known_;  // lines before it have been read, or are in a stretch
  std::deque<Stretch> stretches_;
};

}  // namespace softcnc::ipr
