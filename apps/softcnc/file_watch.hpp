// SPDX-License-Identifier: MIT
// Tells when files change, also where an editor saves by renaming.
#pragma once

#include <map>
#include <set>
#include <span>
#include <string>

#include "descriptor.hpp"
#include "signals.hpp"

namespace softcnc::app {

/// Watches the folders of files by inotify: a file may vanish and come again.
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
  explicit FileWatch(Descriptor queue) : queue_(std::move(queue)) {}
  Status add(const std::string& file);
  bool has_changed();

  Descriptor queue_;
  std::map<int, std::set<std::string>> names_;  // in each watched folder
};

}  // namespace softcnc::app
