// SPDX-License-Identifier: MIT
// What canned cycles do, stop by stop, as a text.
#pragma once

#include <catch2/catch.hpp>

#include "ipr/interpret.hpp"

namespace softcnc::ipr {

/// "R1,2,20 F1,2,-5 D1.5 S-500": rapids, feeds, dwells, turns of the spindle of a faultless
/// program, from behind `head` on, with which they must begin.
inline std::string stops_behind(const std::string& head, std::string program,
                                InterpreterOptions options) {
  std::string all;
  for (const Block& block : blocks_of(std::move(program), {}, options)) {
    if (const auto* move = std::get_if<Move>(&block.what)) {
      const AxisVector to = end(move->path);
      all += (move->rapid ? "R" : "F") + number_text(to.x()) + "," + number_text(to.y()) + "," +
             number_text(to.z()) + " ";
    } else if (const auto* rest = std::get_if<Dwell>(&block.what)) {
      all += "D" + number_text(rest->duration) + " ";
    } else if (std::get<Action>(block.what).kind == Action::Kind::spindle) {
      all += "S" + number_text(std::get<Action>(block.what).value) + " ";
    }
  }
  REQUIRE(all.starts_with(head));
  return all.substr(head.size());
}

}  // namespace softcnc::ipr
