// SPDX-License-Identifier: MIT
// Makes libs/motion/roughness_table.inc by simulated edges; see scripts/roughness_table.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "motion/roughness_table.hpp"
#include "support/edge_surface.hpp"

namespace {

using softcnc::kSimulatedFeeds;
using softcnc::kSimulatedTips;
using softcnc::simulated_tip;

constexpr std::size_t kFeeds = kSimulatedFeeds.size();
constexpr double kScale = 1000, kRoundOff = 1e-6;
constexpr double kLeastSlope = 0.5;  // by a^2: no feed leaps where heights do not grow
constexpr double kBeyond = 1.001;    // of 1 + a^2, which no height far from the tip exceeds

double square(double x) { return x * x; }

/// Nodes and the middles between them: values at 2 i are those of node i.
class FineTable {
 public:
  explicit FineTable(int teeth) {
    for (std::size_t t = 0; t < 2 * kSimulatedTips - 1; ++t) simulate(teeth, t);
    for (std::size_t t = 0; t < static_cast<std::size_t>(kSimulatedTips); ++t)
      for (std::size_t f = 0; f <= kFeeds; ++f) node(t, f) = fine_[2 * t][2 * f];
    for (std::size_t f = 1; f <= kFeeds; ++f) {
      double& last = node(kSimulatedTips - 1, f);
      last = std::max(last, 1 + kBeyond * square(feed(2 * f)));
    }
    cover();
  }

  void print() const {
    for (const auto& heights : nodes_) {
      std::printf("{{");
      double below = 1;
      for (std::size_t f = 1; f <= kFeeds; ++f) {
        const double end = square(feed(2 * f)), least = end - square(feed(2 * f - 2));
        const double height = std::max(heights[f], below + kLeastSlope * least);
        const double part = std::ceil(kScale * (height - 1) / end - kRoundOff);
        below = 1 + part / kScale * end;
        std::printf("%s%.0f", f == 1 ? "" : (f == 15 ? ",\n  " : ", "), part);
      }
      std::printf("}},\n");
    }
  }

 private:
  double& node(std::size_t tip, std::size_t feed) { return nodes_[tip][feed]; }

  static double tip(std::size_t half) {
    const int i = static_cast<int>(half / 2);
    return half % 2 == 0 ? simulated_tip(i) : 0.5 * (simulated_tip(i) + simulated_tip(i + 1));
  }
  static double feed(std::size_t half) {
    const auto at = [](std::size_t i) { return i == 0 ? 0.0 : kSimulatedFeeds[i - 1]; };
    return half % 2 == 0 ? at(half / 2) : 0.5 * (at(half / 2) + at(half / 2 + 1));
  }

  void simulate(int teeth, std::size_t t) {
    fine_[t][0] = 1;
    for (std::size_t f = 1; f <= 2 * kFeeds; ++f)
      fine_[t][f] =
          std::max(fine_[t][f - 1], softcnc::test::EdgeSurface(feed(f), tip(t), teeth).rmax());
  }

  /// Raises nodes until nothing simulated lies above what is interpolated; neither may a lower feed
  /// leave more.
  void cover() {
    for (std::size_t t = 0; t + 1 < 2 * kSimulatedTips - 1; ++t)
      for (std::size_t f = 1; f <= 2 * kFeeds; ++f) raise(t, f);
    for (auto& column : nodes_)
      for (std::size_t f = 1; f <= kFeeds; ++f) column[f] = std::max(column[f], column[f - 1]);
  }

  void raise(std::size_t t, std::size_t f) {
    const std::size_t t0 = t / 2, t1 = (t + 1) / 2, f0 = f / 2, f1 = (f + 1) / 2;
    const double low = square(feed(2 * f0)), high = square(feed(2 * f1));
    const double w = f0 == f1 ? 0 : (square(feed(f)) - low) / (high - low);
    const auto between = [&](std::size_t at) {
      return nodes_[at][f0] + w * (nodes_[at][f1] - nodes_[at][f0]);
    };
    const double lacks = fine_[t][f] - 0.5 * (between(t0) + between(t1));
    if (lacks <= 0) return;
    for (std::size_t at = t0; at <= t1; ++at)
      for (std::size_t by = std::max(f0, std::size_t{1}); by <= f1; ++by)
        nodes_[at][by] += f0 == 0 ? lacks / w : lacks;  // at no feed it stays 1
  }

  double fine_[2 * kSimulatedTips - 1][2 * kFeeds + 1] = {};
  double nodes_[kSimulatedTips][kFeeds + 1] = {};
};

}  // namespace

int main() {
  std::puts("// SPDX-License-Identifier: MIT\n// Made by scripts/roughness_table: do not edit.");
  for (int teeth = 1; teeth <= softcnc::kSimulatedTeeth; ++teeth) {
    std::printf("{{  // teeth: %d\n", teeth);
    FineTable(teeth).print();
    std::puts("}},");
  }
}
