// SPDX-License-Identifier: MIT
#include "pictures/path_pieces.hpp"

#include <cmath>
#include <utility>

namespace softcnc::app {
namespace {

using runtime::HistoryNode;
using runtime::MotionKind;

double apart(Spot a, Spot b) { return std::hypot(b.x - a.x, b.y - a.y); }

class PieceMaker {
 public:
  PieceMaker(const PathColours& colours, const Fineness& fineness)
      : mean_(colours), fineness_(fineness) {}

  void cut(Spot from, Spot to, const HistoryNode& before, const HistoryNode& node) {
    if (spots_.empty()) spots_.push_back(from);
    mean_.add(before, node);
    end_ = to;
    if (apart(spots_.back(), to) >= fineness_.apart) spots_.push_back(to);
    if (apart(spots_.front(), to) >= fineness_.coloured) close();
  }

  void rapid(Spot from, Spot to) {
    close();
    auto& rapids = pieces_.rapids;
    if (rapids.empty() || rapids.back().back() != from) rapids.push_back({from});
    rapids.back().push_back(to);
  }

  /// What has been added up so far becomes a line.
  void close() {
    if (spots_.empty()) return;
    if (spots_.size() < 2 || spots_.back() != end_) spots_.push_back(end_);
    const Colour colour = mean_.take();
    auto& cuts = pieces_.cuts;
    if (cuts.empty() || cuts.back().colour != colour || cuts.back().spots.back() != spots_.front())
      cuts.push_back({{spots_.front()}, colour});
    cuts.back().spots.insert(cuts.back().spots.end(), spots_.begin() + 1, spots_.end());
    spots_.clear();
  }

  PathPieces take() {
    close();
    return std::move(pieces_);
  }

 private:
  ColourMean mean_;
  Fineness fineness_;
  PathPieces pieces_;
  std::vector<Spot> spots_;  // since the last change of the colour
  Spot end_;
};

}  // namespace

PathPieces path_pieces(const runtime::RunHistory& history, const PathColours& colours,
                       const std::function<Spot(const AxisVector&)>& place, const Box& box,
                       const Fineness& fineness) {
  PieceMaker maker(colours, fineness);
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
