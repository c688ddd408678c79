// SPDX-License-Identifier: MIT
// The lines of a program that lose most time against their feed: --worst.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "ipo/queue/block_queue.hpp"

namespace softcnc::runtime {

/// A line, all its rounds in loops and calls together.
struct WorstLine {
  std::string file;  // that the program calls; empty: the program itself
  int line = 0;
  double lost = 0;            // s beyond those that its length takes at the programmed feed
  Limit limit = Limit::feed;  // that takes most of them
};

/// What a line has taken, all its rounds together.
struct LineTime {
  int file = 0;  // Diagnostics::file()
  int line = 0;
  double seconds = 0;         // with its rapids and dwells
  double lost = 0;            // s, as in WorstLine; below 0 where it is faster than its feed
  Limit limit = Limit::feed;  // that takes most of what is lost
};

/// Adds up by line what cutting moves lose. Rapids and dwells have no feed and lose nothing. Memory
/// is bounded by the lines of the program.
class LineLosses {
 public:
  /// The first `until` s of a block; `feed_override` is what counts in it.
  void add(const ipo::TimedBlock& timed, double until, double feed_override);

  /// Returns the lines that have taken time, in the order of files and lines.
  std::vector<LineTime> times() const;

  /// The `count` lines that lose most, the worst first; of two that lose the same the first one.
  /// `file_of`: the name of a file by its number.
  template <typename FileOf>
  std::vector<WorstLine> worst(std::size_t count, FileOf&& file_of) const {
    std::vector<WorstLine> lines;
    for (const Place& place : worst_places(count))
      lines.push_back({place.file == 0 ? std::string() : file_of(place.file), place.line,
                       place.loss->all, place.loss->limit()});
    return lines;
  }

 private:
  struct Loss {
    double all = 0;                      // s
    double seconds = 0;                  // that the line has taken
    std::array<float, kLimits> parts{};  // of it, by limit: enough to see which is the largest

    Limit limit() const noexcept;
  };
  struct Place {
    int file = 0, line = 0;
    const Loss* loss = nullptr;
  };

  Loss& at(const SourcePos& place);
  std::vector<Place> worst_places(std::size_t count) const;

  std::map<int, std::vector<Loss>> lines_;  // of each file, by line
};

}  // namespace softcnc::runtime
