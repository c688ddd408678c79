// SPDX-License-Identifier: MIT
// The option --tolerance: in what two runs have to agree, and how closely.
#pragma once

#include <string>
#include <string_view>

#include "runtime/difference/margins.hpp"

namespace softcnc::app {

/// The tolerance that is asked for. As soon as one is, only what it names is judged.
class Tolerance {
 public:
  /// Adds a list "ASPECT=VALUE,...", where an aspect is time (s, ms, us, %), path or position (mm,
  /// um) or speed (mm/s, mm/min, %); a length alone is that of path and position. Returns what is
  /// wrong with it; empty: nothing.
  std::string add(std::string_view list);

  bool is_named() const noexcept { return named_; }
  const runtime::Margins& margins() const noexcept { return margins_; }

 private:
  std::string add_one(std::string_view word);
  std::string set(runtime::Aspect aspect, std::string_view value);

  runtime::Margins margins_ = runtime::replay_margins();
  bool named_ = false;
};

}  // namespace softcnc::app
