// SPDX-License-Identifier: MIT
#include "motion/roughness/roughness_table.hpp"

#include <algorithm>
#include <cmath>

namespace softcnc {
namespace {

constexpr double kScale = 1e-3;
constexpr int kFeeds = static_cast<int>(kSimulatedFeeds.size());

/// No point lies further along the feed from a cut than this part of the feed per tooth: within a
/// turn of all edges by 2 pi / teeth one of them passes, and the axis, where it passes close by,
/// turns the point by half a turn against them.
constexpr double range(int teeth) noexcept { return 0.5 * (1 + 0.5 * teeth); }

double bound(int teeth, double feed) noexcept {
  const double far = range(teeth) * feed;
  return 1 + 4 * far * far;
}

/// The table at one distance of the tip.
class TableColumn {
 public:
  TableColumn(PassPhase passes, int teeth, double tip) noexcept
      : heights_(kSimulatedHeights[static_cast<std::size_t>(passes)]
                                  [static_cast<std::size_t>(teeth - 1)]) {
    const double fine = kFineTip * kFineTips;
    const double place = tip <= fine ? tip / kFineTip : kFineTips + (tip - fine) / kCoarseTip;
    const double last = kSimulatedTips - 1;
    const double node = std::min(std::floor(place), last);
    low_ = static_cast<std::size_t>(node);
    high_ = static_cast<std::size_t>(std::min(node + 1, last));
    part_ = std::min(place - node, 1.0);
  }

  /// At a node of the feed, from 0; no feed is -1.
  double operator()(int node) const noexcept {
    if (node < 0) return 1;
    const auto f = static_cast<std::size_t>(node);
    const double low = heights_[low_][f], high = heights_[high_][f];
    return 1 + kScale * (low + part_ * (high - low)) * square(node);
  }

  static double square(int node) noexcept {
    if (node < 0) return 0;
    const double feed = kSimulatedFeeds[static_cast<std::size_t>(node)];
    return feed * feed;
  }

  /// The first node whose height is above `height`, or kFeeds.
  int first_above(double height) const noexcept {
    int below = -1, above = kFeeds;
    while (above - below > 1) {
      const int middle = (below + above) / 2;
      ((*this)(middle) > height ? above : below) = middle;
    }
    return above;
  }

 private:
  const SimulatedHeights& heights_;
  std::size_t low_ = 0, high_ = 0;
  double part_ = 0;
};

}  // namespace

const std::array<std::array<SimulatedHeights, kSimulatedTeeth>, 2> kSimulatedHeights{{
// clang-format off
#include "motion/roughness/roughness_table.inc"
    // clang-format on
}};

double edge_height(PassPhase passes, int teeth, double feed, double tip) noexcept {
  if (teeth > kSimulatedTeeth) return bound(teeth, feed);
  const TableColumn column(passes, teeth, tip);
  constexpr double kRoundOff = 1e-9;
  if (feed > kSimulatedFeeds.back() * (1 + kRoundOff))
    return std::max(column(kFeeds - 1), bound(teeth, feed));
  const auto above = std::upper_bound(kSimulatedFeeds.begin(), kSimulatedFeeds.end(), feed);
  const int node = std::min(static_cast<int>(above - kSimulatedFeeds.begin()), kFeeds - 1);
  const double low = TableColumn::square(node - 1), high = TableColumn::square(node);
  const double w = (feed * feed - low) / (high - low);
  return column(node - 1) + w * (column(node) - column(node - 1));
}

double edge_feed(PassPhase passes, int teeth, double height, double tip) noexcept {
  if (!(height > 1)) return 0;
  const double surely = 0.5 * std::sqrt(height - 1) / range(teeth);
  if (teeth > kSimulatedTeeth) return surely;
  const TableColumn column(passes, teeth, tip);
  const int node = column.first_above(height);
  if (node == kFeeds) return std::max(kSimulatedFeeds.back(), surely);
  const double low = TableColumn::square(node - 1), high = TableColumn::square(node);
  const double w = (height - column(node - 1)) / (column(node) - column(node - 1));
  return std::sqrt(low + w * (high - low));
}

}  // namespace softcnc
