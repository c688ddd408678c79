// SPDX-License-Identifier: MIT
#include "api/data.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "runtime/session/feed_script.hpp"

namespace softcnc::api {
namespace {

constexpr double kSlowest = 1e-3;  // mm/s: a constraint that allows less would let a run never end

/// A constraint of the user as one of the planner's.
class CustomConstraint final : public ipo::Constraint {
 public:
  explicit CustomConstraint(std::shared_ptr<const api::Constraint> constraint)
      : constraint_(std::move(constraint)) {}

  Limit limit(const Move&) const noexcept override { return Limit::custom; }

  double velocity_limit(const softcnc::PathPoint& point, const Move& move) const noexcept override {
    const double v =
        constraint_->largest_speed({point.q, point.dq, point.ddq, asked_feed(move, 1), move.rapid});
    const double allowed = v > kSlowest ? v : kSlowest;
    return allowed * allowed;
  }

 private:
  std::shared_ptr<const api::Constraint> constraint_;
};

}  // namespace

RunSetup::RunSetup(const RunOptions& options, runtime::Program* program) {
  channel_.feed_override = std::isnan(options.feed_override)
                               ? 1
                               : std::clamp(options.feed_override, runtime::kSmallestOverride,
                                            runtime::kLargestOverride);
  channel_.interpreter.block_skip = options.block_skip;
  channel_.interpreter.optional_stop = options.optional_stop;
  channel_.interpreter.guess_dialect = options.dialect == Dialect::automatic;
  if (options.dialect != Dialect::automatic)
    channel_.interpreter.dialect = ipr::kAllDialects[static_cast<std::size_t>(options.dialect)];
  channel_.interpreter.subprogram_folders = options.subprogram_folders;
  for (const auto& [name, value] : options.definitions) {
    const auto known = ipr::parse_definition(name + "=0");
    channel_.interpreter.definitions.push_back({known ? known->name : name, value});
  }
  for (const auto& constraint : options.constraints) {
    if (!constraint) continue;
    constraints_.push_back(std::make_unique<CustomConstraint>(constraint));
    channel_.constraints.push_back(constraints_.back().get());
  }
  channel_.state = options.state.data().state;
  if (options.start && is_near(*options.start))
    channel_.state.position = KeptPosition{*options.start};
  if (program == nullptr) return;
  channel_.interpreter.folder = program->folder();
  channel_.interpreter.called = &program->called();
}

}  // namespace softcnc::api
