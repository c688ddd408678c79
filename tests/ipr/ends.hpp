// SPDX-License-Identifier: MIT
// Where the moves of faultless programs end, mm.
#pragma once

#include <catch2/catch.hpp>

#include "ipr/interpret.hpp"

namespace softcnc::ipr {

using Ends = std::vector<AxisVector>;

/// M30 is added to the text.
inline Ends ends(const std::string& text, InterpreterOptions options = {}) {
  Ends all;
  for (const Move& move : moves_of(text + "\nM30\n", {}, options)) all.push_back(end(move.path));
  return all;
}

inline void check_ends(const std::string& text, const Ends& wanted,
                       InterpreterOptions options = {}) {
  INFO(text);
  const Ends got = ends(text, options);
  REQUIRE(got.size() == wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    INFO(i << ": " << got[i].transpose());
    CHECK(near(got[i], wanted[i]));
  }
}

/// Only the X of each.
using Stops = std::vector<double>;
inline Stops places_along_x(std::string text, const InterpreterOptions& options) {
  Stops all;
  for (const Move& move : moves_of(std::move(text), {}, options)) all.push_back(end(move.path).x());
  return all;
}
inline Stops places_along_x(std::string text, Dialect dialect = Dialect::linuxcnc) {
  return places_along_x(std::move(text), in(dialect));
}

/// The X of the last one; -1 if there is none.
inline double last_x(const Interpreted& result) {
  for (const Diagnostic& diagnostic : result.diagnostics) FAIL_CHECK(render(diagnostic));
  double x = -1;
  for (const Block& block : result.blocks)
    if (const auto* move = std::get_if<Move>(&block.what)) x = end(move->path).x();
  return x;
}

}  // namespace softcnc::ipr
