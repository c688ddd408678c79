// SPDX-License-Identifier: MIT
#include "pictures/path_pieces.hpp"

#include <cmath>
#include <utility>

namespace softcnc::app {
namespace {

using runtime::HistoryNode;
using runtime::MotionKind;

class PieceMaker {
 public:
  PieceMaker(const PathColours& colours, double apart) : mean_(colours), apart_(apart) {}

  void cut(Spot from, Spot to, const HistoryNode& before, const HistoryNode& node) {
    if (!open_) begin_ = from;
    open_ = true;
    end_ = to;
    mean_.add(before, node);
    if (std::hypot(to.x - begin_.x, to.y - begin_.y) >= apart_) close();
  }

  void rapid(Spot from, Spot to) {
    close();
    auto& rapids = pieces_.rapids;
    if (rapids.empty() || rapids.back().back() != from) rapids.push_back({from});
    rapids.back().push_back(to);
  }

  /// What has been added up so far becomes a line.
  void close() {
    if (!open_) return;
    open_ = false;
    const Colour colour = mean_.take();
    auto& cuts = pieces_.cuts;
    if (cuts.empty() || cuts.back().colour != colour || cuts.back().spots.back() != begin_)
      cuts.push_back({{begin_}, colour});
    cuts.back().spots.push_back(end_);
  }

  PathPieces take() {
    close();
    return std::move(pieces_);
  }

 private:
  ColourMean mean_;
  double apart_;
  PathPieces pieces_;
  bool open_ = false;
  Spot begin_, end_;
};

}  // namespace

PathPieces path_pieces(const runtime::RunHistory& history, const PathColours& colours,
                       const std::function<Spot(const AxisVector&)>& place, const Box& box,
                       double apart) {
  PieceMaker maker(colours, apart);
  const auto& nodes = history.nodes();
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    const HistoryNode &before = nodes[i - 1], &node = nodes[i];
    AxisVector from = before.position, to = node.position;
    if (node.motion == MotionKind::cutting)
      maker.cut(place(from), place(to), before, node);
    else if (node.motion == MotionKind::rapid && clip_line(from, to, box))
      maker.rapid(place(from), place(to));
    else
      maker.close();
  }
  return maker.take();
}

}  // namespace softcnc::app
