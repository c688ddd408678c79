// SPDX-License-Identifier: MIT
// What is kept of a text that can be read only once: its hash, and its latest lines.
#pragma once

#include <string>
#include <string_view>

#include "hal/files/hash.hpp"

namespace softcnc::runtime {

class StreamMemory {
 public:
  void add(std::string_view bytes);

  /// Returns hash_hex() of all so far.
  std::string hash() const { return hasher_.hex(); }

  /// Returns the text of a line, from 1; an empty string if it is not remembered, or no longer.
  std::string line(int number) const;

 private:
  void forget();

  hal::Hasher hasher_;
  std::string latest_;  // from the beginning of a line
  int first_ = 1;       // its number
};

}  // namespace softcnc::runtime
