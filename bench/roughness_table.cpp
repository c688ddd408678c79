// SPDX-License-Identifier: MIT
// Makes libs/motion/roughness_table.inc by simulated edges; see scripts/generate roughness.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "loose_passes.hpp"
#include "motion/roughness/roughness_table.hpp"
#include "support/edge_surface.hpp"

namespace {

using softcnc::kSimulatedFeeds;
using softcnc::kSimulatedTips;
using softcnc::PassPhase;
using softcnc::simulated_tip;

constexpr std::size_t kFeeds = kSimulatedFeeds.size();
constexpr double kScale = 1000, kRoundOff = 1e-6;
constexpr double kLeastSlope = 0.5;  // by a^2: no feed leaps where heights do not grow
constexpr double kBeyond = 1.001;    // of 1 + a^2, which no height far from the tip exceeds
constexpr double kBetween = 1.02;    // of what is above 1: for what lies between what is simulated
constexpr std::size_t kParts = 3;    // of an interval: at their ends edges are simulated
constexpr std::size_t kTips = kParts * (kSimulatedTips - 1) + 1;

double square(double x) { return x * x; }

/// A place between nodes, whose values are fine[kParts * i].
struct Between {
  explicit Between(std::size_t part)
      : low(part / kParts),
        high((part + kParts - 1) / kParts),
        w(static_cast<double>(part % kParts) / kParts) {}
  double of(double at_low, double at_high) const { return at_low + w * (at_high - at_low); }

  std::size_t low, high;  // nodes
  double w;
};

/// Nodes and some places between them.
class FineTable {
 public:
  FineTable(PassPhase passes, int teeth) {
    for (std::size_t t = 0; t < kTips; ++t) simulate(passes, teeth, t);
    for (std::size_t t = 0; t < static_cast<std::size_t>(kSimulatedTips); ++t)
      for (std::size_t f = 0; f <= kFeeds; ++f) node(t, f) = fine_[kParts * t][kParts * f];
    for (std::size_t f = 1; f <= kFeeds; ++f) {
      double& last = node(kSimulatedTips - 1, f);
      last = std::max(last, 1 + kBeyond * square(feed(kParts * f)));
    }
    cover();
  }

  void print() const {
    for (const auto& heights : nodes_) {
      std::printf("{{");
      double below = 1;
      for (std::size_t f = 1; f <= kFeeds; ++f) {
        const double end = square(feed(kParts * f)), least = end - square(feed(kParts * (f - 1)));
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

  static double tip(std::size_t part) {
    const Between at(part);
    return at.of(simulated_tip(static_cast<int>(at.low)), simulated_tip(static_cast<int>(at.high)));
  }
  static double feed(std::size_t part) {
    const auto node = [](std::size_t i) { return i == 0 ? 0.0 : kSimulatedFeeds[i - 1]; };
    const Between at(part);
    return at.of(node(at.low), node(at.high));
  }

  static double rmax(PassPhase passes, double feed, double tip, int teeth) {
    return passes == PassPhase::in_phase ? softcnc::test::EdgeSurface(feed, tip, teeth).rmax()
                                         : softcnc::LoosePasses(feed, tip, teeth).rmax();
  }

  void simulate(PassPhase passes, int teeth, std::size_t t) {
    fine_[t][0] = 1;
    for (std::size_t f = 1; f <= kParts * kFeeds; ++f) {
      const double height = rmax(passes, feed(f), tip(t), teeth);
      fine_[t][f] = std::max(fine_[t][f - 1], 1 + kBetween * (height - 1));
    }
  }

  /// Raises nodes until nothing simulated lies above what is interpolated; neither may a lower feed
  /// leave more.
  void cover() {
    for (std::size_t t = 0; t < kTips; ++t)
      for (std::size_t f = 1; f <= kParts * kFeeds; ++f) raise(t, f);
    for (auto& column : nodes_)
      for (std::size_t f = 1; f <= kFeeds; ++f) column[f] = std::max(column[f], column[f - 1]);
  }

  void raise(std::size_t t, std::size_t f) {
    const Between tip(t);
    const std::size_t f0 = f / kParts, f1 = (f + kParts - 1) / kParts;
    const double low = square(feed(kParts * f0)), high = square(feed(kParts * f1));
    const double w = f0 == f1 ? 0 : (square(feed(f)) - low) / (high - low);
    const auto between = [&](std::size_t at) {
      return nodes_[at][f0] + w * (nodes_[at][f1] - nodes_[at][f0]);
    };
    const double lacks = fine_[t][f] - tip.of(between(tip.low), between(tip.high));
    if (lacks <= 0) return;
    for (std::size_t at = tip.low; at <= tip.high; ++at)
      for (std::size_t by = std::max(f0, std::size_t{1}); by <= f1; ++by)
        nodes_[at][by] += f0 == 0 ? lacks / w : lacks;  // at no feed it stays 1
  }

  double fine_[kTips][kParts * kFeeds + 1] = {};
  double nodes_[kSimulatedTips][kFeeds + 1] = {};
};

}  // namespace

int main() {
  std::puts("// SPDX-License-Identifier: MIT\n// Made by scripts/generate roughness: do not edit.");
  for (const PassPhase passes : {PassPhase::in_phase, PassPhase::at_any_phase}) {
    std::printf("{{  // %s\n", passes == PassPhase::in_phase ? "in phase" : "at any phase");
    for (int teeth = 1; teeth <= softcnc::kSimulatedTeeth; ++teeth) {
      std::printf("{{  // teeth: %d\n", teeth);
      FineTable(passes, teeth).print();
      std::puts("}},");
    }
    std::puts("}},");
  }
}
