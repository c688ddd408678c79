// SPDX-License-Identifier: MIT
// A part program that can be read more than once.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "ipr/text/called_texts.hpp"
#include "ipr/text/reader.hpp"
#include "motion/core/result.hpp"
#include "runtime/program/descriptor.hpp"
#include "runtime/program/stream_memory.hpp"

namespace softcnc::runtime {

/// How often a program is read: its motion is that of the text that was checked before.
enum class Readings : std::uint8_t { one, any };

class Program {
 public:
  /// Opens a program, or standard input if its name is "-". What is to be read more than once is
  /// copied first, so that every reading finds the same; otherwise a pipe is streamed. Errors:
  /// SC6001, SC6002, SC6003.
  static Result<Program> open(const std::string& name, Readings readings = Readings::any);
  /// A program that lies in `file` already.
  static Program in_file(std::string name, Descriptor file);

  /// The name that the user gave; "<stdin>" for "-".
  const std::string& name() const noexcept { return name_; }

  /// The folder of the files that the program calls: its own; empty if it comes from a pipe.
  const std::string& folder() const noexcept { return folder_; }
  void set_folder(std::string folder) { folder_ = std::move(folder); }

  /// The texts of the files that it calls, the same for every reading.
  ipr::CalledTexts& called() const noexcept { return *called_; }

  /// Returns a reader from the beginning. A stream has one reader at a time.
  ipr::Reader reader();

  /// Returns whether the text can be read only once.
  bool streamed() const noexcept { return stream_ != nullptr; }
  int descriptor() const noexcept { return *file_; }

  /// Returns the size of the text in bytes; 0 if that is not known, as of a stream.
  std::uint64_t size() const noexcept;

  /// Returns hash_hex() of the text. What has not been read yet of a streamed text is read first.
  const std::string& hash();

  /// Returns whether all that was asked for by hash() and for_each_piece() could be read: what
  /// could not looks like the end of the text. Errors: SC6002.
  Status read_status() const;

  /// Returns the text of a line, from 1; empty after the end, and where a stream has long passed
  /// it. A reader may be active; cheap where lines are asked for in their order.
  std::string line(int number);

  /// Calls take(bytes) for the text, piece by piece, from the beginning.
  template <typename Take>
  void for_each_piece(Take&& take);

 private:
  Program(std::string name, Descriptor file, off_t begin);
  void read_rest();
  std::size_t read(off_t from, char* to, std::size_t size);

  std::string name_, folder_;
  Descriptor file_;
  off_t begin_;
  std::string hash_;
  int error_ = 0;  // of a read that failed
  std::unique_ptr<StreamMemory> stream_;
  std::unique_ptr<ipr::CalledTexts> called_ = std::make_unique<ipr::CalledTexts>();

  std::optional<ipr::Reader> lines_;  // reads lines for diagnostics
  std::string line_;
};

template <typename Take>
void Program::for_each_piece(Take&& take) {
  std::string piece(65536, '\0');
  off_t at = begin_;
  while (const std::size_t n = read(at, piece.data(), piece.size())) {
    take(std::string_view(piece.data(), n));
    at += static_cast<off_t>(n);
  }
}

}  // namespace softcnc::runtime
