// SPDX-License-Identifier: MIT
// Files that a reader sees whole or not at all.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "hal/hash.hpp"  // IWYU pragma: export
#include "motion/result.hpp"

namespace softcnc::hal {

/// Somewhere bytes go, in order.
class ByteSink {
 public:
  virtual ~ByteSink() = default;
  virtual Status write(std::string_view bytes) = 0;

  /// Call once after the last write; without it nothing is kept.
  virtual Status finish() = 0;
};

/// A file is written as FILE.part, which finish() syncs and renames; an unfinished one is removed.
/// What exists and is no regular file (a pipe, /dev/null) is written directly, and "-" is standard
/// output. Errors: SC6011 (cannot be created), SC6012 (writing failed), SC6013 (the reader closed
/// the pipe; only where SIGPIPE is ignored).
class OutputFile final : public ByteSink {
 public:
  static Result<std::unique_ptr<OutputFile>> open(const std::string& file);

  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile() override;

  Status write(std::string_view bytes) override;
  Status finish() override;

 private:
  OutputFile(std::string name, std::string part, std::string target, int descriptor);
  Status failed() const;

  std::string name_;    // as the user said it
  std::string part_;    // empty: written directly
  std::string target_;  // what part_ is renamed to
  int descriptor_;
};

/// The file that is made or replaced where this name is written to: at the end of symbolic links,
/// be it there already or not.
std::string target_of(const std::string& file);

/// FILE.part, as which `file` is written; empty where it is written directly.
std::string part_of(const std::string& file);

/// All of `text` into `file`, by the same rules.
Status write_file(const std::string& file, std::string_view text);

}  // namespace softcnc::hal
