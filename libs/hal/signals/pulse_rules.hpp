// SPDX-License-Identifier: MIT
// The validator of pulse rules: reads any list of signal edges, however it was made.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "hal/signals/step_edges.hpp"

namespace softcnc::hal {

enum class PulseRule : std::uint8_t {
  length,
  space,
  interval,
  setup,
  hold,
  direction_in_step,  // it stands still there
  change,             // an edge is one
  order,              // of time, in which edges come
  end                 // of a step: it has one
};
inline constexpr std::array<std::string_view, 9> kPulseRuleNames{
    "step length",      "step space",     "step interval",
    "direction set-up", "direction hold", "direction during a step",
    "no change",        "order of time",  "step without end"};
constexpr std::string_view name(PulseRule rule) noexcept {
  return kPulseRuleNames[static_cast<std::size_t>(rule)];
}
/// The number of rules that require a least time; they come first.
inline constexpr std::size_t kTimedRules = 5;

/// Returns the least time, ns, that a rule requires.
std::int64_t least(PulseRule rule, const StepTiming& timing) noexcept;

struct BrokenRule {
  SignalEdge edge;
  PulseRule rule;
  std::int64_t is, least;  // ns
};

/// Returns a description with axis and time.
std::string text(const BrokenRule& broken);

/// Checks edges as a driver would see them on its lines, all of which begin low.
class PulseRules {
 public:
  /// The figures that are measured on the lines of an axis.
  struct Figures {
    std::int64_t steps = 0, broken = 0;
    std::array<std::optional<std::int64_t>, kTimedRules> shortest;  // ns, by rule
  };
  using Report = std::function<void(const BrokenRule&)>;

  /// Makes the rules; every broken rule goes to `report`.
  explicit PulseRules(const StepTiming& timing, Report report = {})
      : timing_(timing), report_(std::move(report)) {}

  void read(std::span<const SignalEdge> edges);
  void read(const SignalEdge& edge);
  /// A line does not begin low.
  void begin(const SignalEdge& level) noexcept;
  /// Ends the edges: steps have ended. To be called once, last, if at all.
  void finish();

  /// The first rule that was broken, in words.
  const std::optional<std::string>& broken() const noexcept { return first_broken_; }
  /// Returns the steps so far; those in negative direction count -1.
  const GridPoint& counts() const noexcept { return counts_; }
  const Figures& figures(int axis) const noexcept {
    return figures_[static_cast<std::size_t>(axis)];
  }
  std::int64_t steps() const noexcept;
  /// Returns the shortest interval between two steps of one axis, ns; 0 if there were none.
  std::int64_t shortest_interval() const noexcept;
  std::int64_t edges() const noexcept { return edges_; }
  /// Returns the time of the last edge, ns.
  std::int64_t time() const noexcept { return time_; }

 private:
  struct Line {
    std::array<bool, 2> level{};  // by wire
    std::optional<std::int64_t> rise, fall, turn;
  };

  void read_step(const SignalEdge& edge, Line& line);
  void read_direction(const SignalEdge& edge, Line& line);
  void measure(PulseRule rule, const SignalEdge& edge, const std::optional<std::int64_t>& since);
  void report(const BrokenRule& broken);

  StepTiming timing_;
  Report report_;
  std::array<Line, kAxes> lines_{};
  std::array<Figures, kAxes> figures_{};
  std::int64_t time_ = 0, edges_ = 0;
  GridPoint counts_{};
  std::optional<std::string> first_broken_;
};

}  // namespace softcnc::hal
