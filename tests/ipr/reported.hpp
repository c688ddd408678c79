// SPDX-License-Identifier: MIT
// What is reported of a program that lacks only its end.
#pragma once

#include "ipr/interpret.hpp"

namespace softcnc::ipr {

/// The places of its diagnostics; M30 is added to the text.
inline Places reported(std::string text, Dialect dialect = Dialect::linuxcnc) {
  InterpreterOptions options;
  options.dialect = dialect;
  return places(interpret(std::move(text) + "\nM30\n", Machine{}, options));
}

}  // namespace softcnc::ipr
