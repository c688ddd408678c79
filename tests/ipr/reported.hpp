// SPDX-License-Identifier: MIT
// What is reported of a program that lacks only its end.
#pragma once

#include "ipr/interpret.hpp"

namespace softcnc::ipr {

/// The places of its diagnostics; M30 is added to the text.
inline Places reported(std::string text, const InterpreterOptions& options,
                       const Machine& machine = {}) {
  return places(interpret(std::move(text) + "\nM30\n", machine, options));
}
inline Places reported(std::string text, Dialect dialect = Dialect::linuxcnc,
                       const Machine& machine = {}) {
  return reported(std::move(text), in(dialect), machine);
}

inline Places haas_reported(std::string text, const Machine& machine = {}) {
  return reported(std::move(text), kHaas, machine);
}

}  // namespace softcnc::ipr
