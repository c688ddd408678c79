// SPDX-License-Identifier: MIT
// How often memory was asked for: linking this replaces operator new by one that counts.
#pragma once

namespace softcnc::test {

/// Calls of operator new since the program started.
long allocations() noexcept;

template <typename Work>
long allocations_during(Work&& work) {
  const long before = allocations();
  work();
  return allocations() - before;
}

}  // namespace softcnc::test
