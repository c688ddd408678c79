// SPDX-License-Identifier: MIT
// Passing over lines: the definition of Flow::pass_to, for its own sources.
#pragma once

#include "ipr/flow/flow.hpp"

namespace softcnc::ipr {

/// Skips lines until `wanted` returns true for one; before_ is then the spot before it. Returns
/// false at the end of the subprogram or program. What cannot be read may have begun or ended
/// something: that counts where it will be reported, since reading goes back after false, and all
/// is read if unreachable_too.
template <typename Wanted>
bool Flow::pass_to(Wanted wanted) {
  moved_ = true;
  std::string definition;  // of a subprogram, which is passed over as a whole
  const bool structure_was_unknown = structure_unknown_;
  for (;;) {
    const auto line = parser_.next_statement();
    if (!line) return false;
    const Kind kind = line->statement ? line->statement->kind : Kind::none;
    if (line->broken && kind == Kind::none) structure_unknown_ = true;
    if (line->unread.has('N') && options_.unreachable_too) line_numbers_unknown_ = true;
    if (!definition.empty()) {
      if (kind == Kind::end_sub && line->statement->label == definition) definition.clear();
    } else if (wanted(*line)) {
      if (!options_.unreachable_too) structure_unknown_ = structure_was_unknown;
      before_ = {parser_.file(), parser_.reader().place_before(line->text)};
      return true;
    } else if (kind == Kind::sub) {
      definition = line->statement->label;
    } else if (kind == Kind::end_sub || kind == Kind::program) {
      return false;
    }
  }
}

}  // namespace softcnc::ipr
