// SPDX-License-Identifier: MIT
// Curves out of part programs, and points to compare them with.
#pragma once

#include <catch2/catch.hpp>

#include "ipr/interpret.hpp"

namespace softcnc::ipr {

/// The curves of a program that has to be without any error; notes are let through.
inline std::vector<Block> curves_of(const std::string& program, const Machine& machine = {},
                                    InterpreterOptions options = {}) {
  Interpreted result = interpret(program, machine, options);
  for (const Diagnostic& d : result.diagnostics)
    if (d.severity() == Severity::error) FAIL(render(d));
  std::vector<Block> curves;
  for (Block& block : result.blocks)
    if (const auto* move = std::get_if<Move>(&block.what))
      if (std::holds_alternative<Nurbs>(move->path)) curves.push_back(std::move(block));
  return curves;
}

inline const Move& move_of(const Block& block) { return std::get<Move>(block.what); }
inline const Nurbs& nurbs_of(const Block& block) { return std::get<Nurbs>(move_of(block).path); }

inline void check_point(const Nurbs& curve, double u, const AxisVector& expected) {
  INFO("u = " << u << ": " << curve.point(u).transpose() << ", not " << expected.transpose());
  CHECK((curve.point(u) - expected).norm() < 1e-12);
}

}  // namespace softcnc::ipr
