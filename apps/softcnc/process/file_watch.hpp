// SPDX-License-Identifier: MIT
// Reports when files change, also where an editor saves by renaming.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <string>

#include "process/signals.hpp"
#include "runtime/program/descriptor.hpp"

namespace softcnc::app {

/// What is there under the name of a file, links followed; all 0 for nothing.
struct FileStamp {
  std::uint64_t device = 0, number = 0;
  std::int64_t size = 0, second = 0, nanosecond = 0;

  friend bool operator==(const FileStamp&, const FileStamp&) = default;
};

/// Watches the folders of files by inotify: a file may vanish and come again. What that does not
/// see, as of a folder that is made again or a link that leads elsewhere, is looked for once a
/// second.
class FileWatch {
 public:
  /// Errors: SC6041.
  static Result<FileWatch> open(std::span<const std::string> files);

  /// Further files. Those that cannot be watched are not.
  void also(std::span<const std::string> files);

  /// Returns true when a file has changed since the last call, or since open(), and has then been
  /// left alone for a moment; false when a signal has come.
  bool wait(StopSignals& signals);

 private:
  explicit FileWatch(runtime::Descriptor queue) : queue_(std::move(queue)) {}
  Status add(const std::string& file);
  bool has_changed();
  void look();
  bool looks_changed();
  void watch_again();

  runtime::Descriptor queue_;
  std::map<int, std::set<std::string>> names_;  // in each watched folder
  struct Seen {
    FileStamp reported, last;  // what wait() has returned for; what was there a second ago
  };
  std::map<std::string, Seen> seen_;
};

}  // namespace softcnc::app
