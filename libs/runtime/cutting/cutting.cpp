// SPDX-License-Identifier: MIT
#include "runtime/cutting/cutting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "motion/core/units.hpp"
#include "runtime/figures/pass_neighbours.hpp"
#include "runtime/program/each_block.hpp"

namespace softcnc::runtime {
namespace {

constexpr int kBetweenLooks = 256;  // blocks, at whether the work is to stop
constexpr int kMostTeeth = 100;     // the work of a second grows with their square

class CuttingReader {
 public:
  CuttingReader(const Machine& machine, Diagnostics& diagnostics)
      : machine_(machine), diagnostics_(diagnostics) {}

  void read(const Block& block) {
    if (const auto* action = std::get_if<Action>(&block.what)) act(*action);
    if (const auto* move = std::get_if<Move>(&block.what)) read(*move, block);
  }

  Cutting finish() {
    if (!cutting_.tips && diagnostics_.errors() == 0)
      diagnostics_.report({.code = Code::SC2382, .message = "the program has no cutting move"});
    return std::move(cutting_);
  }

 private:
  void act(const Action& action) {
    if (action.kind == Action::Kind::spindle) spin_ = -rad_s_from_rpm(action.value);
    if (action.kind != Action::Kind::tool) return;
    const auto found = machine_.tools.find(static_cast<int>(action.value));
    tool_ = found == machine_.tools.end() ? Tool{} : found->second;
  }

  void read(const Move& move, const Block& block) {
    const surface::Cutter cutter = cutter_of(move);
    const double target = move.surface ? move.surface->rmax : 0;
    const bool begins = !move.rapid && begins_pass(move);
    if (!move.rapid) add(move, cutter, block);
    const auto& changes = cutting_.changes;
    if (begins || changes.empty() || changes.back().cutter != cutter ||
        changes.back().cutting == move.rapid || changes.back().target != target)
      cutting_.changes.push_back(
          {block.number, cutter, !move.rapid, start(move.path), target, begins});
    direction_ = at(move.path, length(move.path), Side::before).dq;
    after_rapid_ = move.rapid;
  }

  /// What a program says of its tool counts until it changes it: on rapids too, so that the spindle
  /// turns on between passes.
  surface::Cutter cutter_of(const Move& move) {
    if (move.surface) {
      tool_.radius = move.surface->tool_radius;
      tool_.teeth = move.surface->teeth;
    }
    return {tool_.radius, tool_.teeth, spin_};
  }

  bool begins_pass(const Move& move) const {
    return after_rapid_ || direction_.dot(at(move.path, 0.0).dq) < kPassTurn;
  }

  void add(const Move& move, const surface::Cutter& cutter, const Block& block) {
    if (cutter.radius <= 0 || cutter.teeth <= 0)
      return report_once(Code::SC2380, "no tool with a radius and teeth is in the spindle", block);
    if (cutter.teeth > kMostTeeth)
      return report_once(Code::SC4041,
                         fmt::format("a tool of {} teeth; a surface can be cut with at most {}",
                                     cutter.teeth, kMostTeeth),
                         block);
    if (cutter.spin == 0)
      return report_once(Code::SC2381, "a cutting move while the spindle stands still", block);
    const Extent box = bounds(move.path);
    if (!cutting_.tips) cutting_.tips = box;
    cutting_.tips->include(box.min);
    cutting_.tips->include(box.max);
    cutting_.radius = std::max(cutting_.radius, cutter.radius);
    cutting_.feed_per_tooth =
        std::max(cutting_.feed_per_tooth, move.feed * surface::ToolTrack::tooth_period(cutter));
    if (move.surface) cutting_.pick_feed = std::max(cutting_.pick_feed, move.surface->pick_feed);
  }

  void report_once(Code code, std::string text, const Block& block) {
    if (std::exchange(reported_, true)) return;
    diagnostics_.report({.code = code, .pos = block.source, .message = std::move(text)});
  }

  const Machine& machine_;
  Diagnostics& diagnostics_;
  Cutting cutting_;
  Tool tool_;
  double spin_ = 0;
  AxisVector direction_ = AxisVector::Zero();
  bool after_rapid_ = true, reported_ = false;
};

}  // namespace

Cutting read_cutting(Program& program, const Machine& machine, const ChannelOptions& options,
                     Diagnostics& diagnostics, Watcher& watcher) {
  ipr::Reader text = program.reader();
  ipr::Parser parser(text, diagnostics);
  ipr::Interpreter interpreter(parser, machine, diagnostics, options.interpreter, options.state);
  CuttingReader reader(machine, diagnostics);
  const auto take = [&](const Block& block) {
    reader.read(block);
    return block.number % kBetweenLooks != 0 || !watcher.wants_stop();
  };
  const auto wait = [&] {
    watcher.wait_for_input(program.descriptor());
    return !watcher.wants_stop();
  };
  each_block(interpreter, take, wait);
  return watcher.wants_stop() ? Cutting{} : reader.finish();
}

}  // namespace softcnc::runtime
