// SPDX-License-Identifier: MIT
// What an operator has done and what has come of it, line by line.
#pragma once

#include <cstdint>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "motion/core/result.hpp"

namespace softcnc::app {

enum class EntryKind : std::uint8_t {
  action,  // of the operator
  note,
  fault,
};

class Journal {
 public:
  struct Entry {
    EntryKind kind;
    std::string text;
  };
  static constexpr std::size_t kKept = 200;

  /// Entries are added to the end of a file, too, each at once, unless its name is empty. Errors:
  /// SC6011.
  Status open(const std::string& file);

  /// The time of the entries that follow, s.
  void set_time(double now) noexcept { now_ = now; }
  /// Adds an entry; each line of the text is one of its own.
  void add(EntryKind kind, std::string_view text);
  /// Adds an error as a fault, all else as a note; where it is `of_program`, with its line.
  void add(const Diagnostic& diagnostic, bool of_program = false);

  /// Returns the notes and faults since the last action, the oldest first.
  const std::vector<Entry>& news() const noexcept { return news_; }
  /// Returns whether all entries are in the file. Errors: SC6012.
  Status finish();

 private:
  void add_line(EntryKind kind, std::string_view line);

  std::string name_;
  std::ofstream file_;
  double now_ = 0;           // s
  bool has_failed_ = false;  // the file
  std::vector<Entry> news_;
};

}  // namespace softcnc::app
