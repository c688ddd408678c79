// SPDX-License-Identifier: MIT
// Offsets and the rotation of a work system.
#include "ipr/state/coordinates.hpp"

#include <cmath>

namespace softcnc::ipr {
namespace {

AxisVector turned_about_z(const AxisVector& v, double cosine, double sine) noexcept {
  return {cosine * v[0] - sine * v[1], sine * v[0] + cosine * v[1], v[2]};
}

}  // namespace

Coordinates::Coordinates(const WorkOffset& work, const AxisVector& shift,
                         const AxisVector& tool) noexcept
    : moved_(tool + work.origin),
      shift_(shift),
      sum_(moved_ + shift),
      cosine_(work.rotation == 0 ? 1 : std::cos(work.rotation)),
      sine_(work.rotation == 0 ? 0 : std::sin(work.rotation)) {}

AxisVector Coordinates::to_machine(const AxisVector& program) const noexcept {
  if (!rotated()) return program + sum_;
  return moved_ + direction(program + shift_);
}

AxisVector Coordinates::to_program(const AxisVector& machine) const noexcept {
  if (!rotated()) return machine - sum_;
  return turned_about_z(machine - moved_, cosine_, -sine_) - shift_;
}

AxisVector Coordinates::direction(const AxisVector& program) const noexcept {
  return rotated() ? turned_about_z(program, cosine_, sine_) : program;
}

}  // namespace softcnc::ipr
