// SPDX-License-Identifier: MIT
// Files that a reader sees whole or not at all.
#pragma once

#include <memory>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>

#include "hal/files/hash.hpp"  // IWYU pragma: export
#include "motion/core/result.hpp"

namespace softcnc::hal {

/// Returns an error of a file.
tl::unexpected<Diagnostic> file_failure(Code code, const std::string& file, std::string message);

/// A destination of bytes.
class ByteSink {
 public:
  virtual ~ByteSink() = default;
  virtual Status write(std::string_view bytes) = 0;

  /// Completes the output. Call once after the last write; without it nothing is kept.
  virtual Status finish() = 0;
};

/// How long a pipe may have no reader, or one that takes nothing. Longer is an error.
struct Patience {
  static constexpr int kAfterStop = 300;  // ms

  std::stop_token stop;    // once it is requested, kAfterStop
  int while_running = -1;  // ms; -1: without end
};

/// A file is written under a name of its own beside its target (hal/unfinished_file.hpp), which
/// finish() syncs and renames; an unfinished one is removed, and what was there stays. One that
/// replaces another takes over its mode and, where that is allowed, its owner and group. What
/// exists and is no regular file (a pipe, /dev/null) is written directly, and "-" is standard
/// output. Errors: SC6011 (cannot be created), SC6012 (writing failed), SC6013 (the reader closed
/// the pipe; only where SIGPIPE is ignored).
class OutputFile final : public ByteSink {
 public:
  static Result<std::unique_ptr<OutputFile>> open(const std::string& file, Patience patience = {});

  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile() override;

  Status write(std::string_view bytes) override;
  Status finish() override;

 private:
  OutputFile(std::string name, Patience patience)
      : name_(std::move(name)), patience_(std::move(patience)) {}
  void begin(std::string target);
  int open_directly() const;
  bool has_reader() const;
  Status failed() const;

  std::string name_;        // as the user said it
  std::string unfinished_;  // empty: written directly
  std::string target_;      // what that is renamed to
  Patience patience_;
  int descriptor_ = -1;
  bool may_wait_ = false;  // for a reader
};

/// Returns the file that writing to this name makes or replaces: at the end of symbolic links,
/// whether it exists or not.
std::string target_of(const std::string& file);

/// Returns whether `file` is replaced as a whole, or made; false where it is written directly.
bool is_replaced(const std::string& file);

/// Writes all of `text` into `file`, by the same rules.
Status write_file(const std::string& file, std::string_view text, Patience patience = {});

}  // namespace softcnc::hal
