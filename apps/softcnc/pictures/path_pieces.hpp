// SPDX-License-Identifier: MIT
// A path as lines of one colour each, no finer than a picture can show.
#pragma once

#include <functional>
#include <vector>

#include "pictures/path_colour.hpp"
#include "pictures/path_view.hpp"

namespace softcnc::app {

struct PathPiece {
  std::vector<Spot> spots;  // at least two
  Colour colour;
};

struct PathPieces {
  std::vector<PathPiece> cuts;  // in the order of the program
  std::vector<std::vector<Spot>> rapids;
};

/// How fine the pieces are, px.
struct Fineness {
  double apart = 1;     // between the spots of a line, at least, except at the ends of pieces
  double coloured = 1;  // from one change of the colour to where the next one may be
};

/// Returns the moves of a run where `place` puts their ends. Neighbours of the same colour are one
/// piece. Of rapids, what lies in `box` counts.
PathPieces path_pieces(const runtime::RunHistory& history, const PathColours& colours,
                       const std::function<Spot(const AxisVector&)>& place, const Box& box,
                       const Fineness& fineness);

}  // namespace softcnc::app
