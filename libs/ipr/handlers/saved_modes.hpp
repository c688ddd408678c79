// SPDX-License-Identifier: MIT
// What M70 to M73 have saved, level by level of the calls.
#pragma once

#include "ipr/flow/flow.hpp"
#include "ipr/lines/output.hpp"
#include "ipr/state/modal.hpp"

namespace softcnc::ipr {

/// Every call has a level of its own, at whose end what M73 has saved in it is restored.
class SavedLevels final : public CallObserver {
 public:
  /// `modal` must outlive the levels.
  explicit SavedLevels(Modal& modal) : modal_(modal) {}

  void begin_call() override { modal_.saved.emplace_back(); }
  void end_call(const SourcePos& pos) override;
  void miss_call() override;

 private:
  Modal& modal_;
};

/// Lets spindle, coolant and cutter compensation follow modes that have been restored.
void follow_restored(const Modes& before, Modal& modal, Output& out, const SourcePos& source);

}  // namespace softcnc::ipr
