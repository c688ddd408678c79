// SPDX-License-Identifier: MIT
// The variables through which a program reads position, offsets and modes.
#pragma once

#include <set>

#include "ipr/expressions/parameters.hpp"
#include "ipr/state/modal.hpp"
#include "ipr/state/offset_variables.hpp"
#include "ipr/state/tool_table.hpp"

namespace softcnc::ipr {

/// The variables of position, offsets and modes. What an error has made unknown is kUnknown.
/// Offsets, lengths and radii are in mm, as a machine keeps them; in the fanuc dialect they are in
/// the units of the program. Rotations are in degrees, the rest is in the units of the program.
class ModalVariables final : public SystemVariables {
 public:
  /// Makes the variables. Everything referred to must outlive them.
  ModalVariables(Modal& modal, const Machine& machine, Dialect dialect)
      : modal_(modal), machine_(machine), dialect_(dialect) {}

  void set_dialect(Dialect dialect) noexcept { dialect_ = dialect; }

  std::optional<double> read(int number) const override;
  std::optional<double> read(std::string_view name) const override;
  bool has(int number, Dialect dialect) const override;
  bool is_read_only(int number) const override;
  double limit(int number) const override;
  bool assumes_unit(int number) const override;
  double fanuc_unit(int number) const override;
  bool write(int number, double value) override;
  void keep(int number, double value) override;
  void keep(std::string_view name, double value) override;

 private:
  ToolTable tools() const noexcept { return {modal_.state, machine_, dialect_}; }
  double diameter() const;
  double tool_length(int axis) const;
  std::optional<ToolVariable> of_tool_in(int number) const;
  bool is_offset(int number) const;
  double unit() const noexcept;
  bool knows_unit() const noexcept;
  std::optional<double> read_linuxcnc(int number) const;
  std::optional<double> read_fanuc(int number) const;
  void write_offset(int number, double value);
  bool write_fanuc(int number, double value);

  Modal& modal_;
  const Machine& machine_;
  Dialect dialect_;
  std::set<int> unknown_;  // numbers of variables that an error has left without a value
};

}  // namespace softcnc::ipr
