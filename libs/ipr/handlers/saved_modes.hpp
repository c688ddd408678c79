// SPDX-License-Identifier: MIT
// What M70 to M73 have saved, level by level of the calls.
#pragma once

#include "ipr/flow/flow.hpp"
#include "ipr/lines/output.hpp"
#include "ipr/state/modal.hpp"

namespace softcnc::ipr {

/// The saved modes, with a level for every call. At the end of a call, what M73 has saved in its
/// level is restored.
class SavedLevels final : public CallObserver {
 public:
  /// Makes the levels; `modal` must outlive them.
  explicit SavedLevels(Modal& modal) : modal_(modal) {}

  void begin_call() override { modal_.saved.emplace_back(); }
  void end_call(const SourcePos& pos) override;
  void miss_call() override;

 private:
  Modal& modal_;
};

/// Emits blocks that make spindle, coolant and cutter compensation follow modes that have been
/// restored.
void follow_restored(const Modes& before, Modal& modal, Output& out, const SourcePos& source);

}  // namespace softcnc::ipr
