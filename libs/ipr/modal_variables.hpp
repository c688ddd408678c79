// SPDX-License-Identifier: MIT
// The variables through which a program reads position, offsets and modes.
#pragma once

#include <set>

#include "ipr/modal.hpp"
#include "ipr/parameters.hpp"

namespace softcnc::ipr {

/// What an error has made unknown is kUncertain. Offsets (#5161 to #5403) are
/// in mm, as a machine keeps them; the rest is in the units of the program.
class ModalVariables final : public SystemVariables {
 public:
  /// `modal` must outlive the variables.
  ModalVariables(Modal& modal, Dialect dialect) : modal_(modal), dialect_(dialect) {}

  std::optional<double> read(int number) const override;
  std::optional<double> read(std::string_view name) const override;
  bool is_read_only(int number) const override;
  bool write(int number, double value) override;

 private:
  double* offset(int number) const noexcept;
  std::optional<double> read_fanuc(int number) const;
  bool write_fanuc(int number, double value);

  Modal& modal_;
  Dialect dialect_;
  std::set<int> uncertain_;  // numbers of variables that an error has left without a value
};

}  // namespace softcnc::ipr
