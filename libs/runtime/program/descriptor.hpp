// SPDX-License-Identifier: MIT
// A file descriptor with an owner, and files without a name.
#pragma once

#include <stop_token>
#include <string>
#include <string_view>

#include "motion/core/result.hpp"

namespace softcnc::runtime {

class Descriptor {
 public:
  explicit Descriptor(int number) noexcept : number_(number) {}
  Descriptor(Descriptor&& other) noexcept;
  Descriptor& operator=(Descriptor&& other) noexcept;
  ~Descriptor();

  int operator*() const noexcept { return number_; }

 private:
  int number_;
};

/// Returns when there is something to read, or a stop has been requested.
void wait_for_input(int descriptor, const std::stop_token& stop = {});

/// Returns whether there is something to read, or the end of the text, within `timeout` ms.
bool has_input(int descriptor, int timeout) noexcept;

/// Makes an empty file that vanishes with its descriptor. Errors: SC6003.
Result<Descriptor> unlinked_file();

/// Writes all of `bytes`. Errors: SC6003.
Status write_all(const Descriptor& file, std::string_view bytes);

}  // namespace softcnc::runtime
