// SPDX-License-Identifier: MIT
#include "api/data.hpp"

#include <utility>

namespace softcnc::api {
namespace {

/// A constraint of the user as one of the planner's.
class CustomConstraint final : public ipo::Constraint {
 public:
  explicit CustomConstraint(std::shared_ptr<const api::Constraint> constraint)
      : constraint_(std::move(constraint)) {}

  Limit limit(const Move&) const noexcept override { return Limit::custom; }

  double velocity_limit(const softcnc::PathPoint& point, const Move& move) const noexcept override {
    const double v =
        constraint_->largest_speed({point.q, point.dq, point.ddq, asked_feed(move, 1), move.rapid});
    return v * v;
  }

 private:
  std::shared_ptr<const api::Constraint> constraint_;
};

}  // namespace

RunSetup::RunSetup(const RunOptions& options, runtime::Program* program) {
  channel_.feed_override = options.feed_override;
  channel_.interpreter.block_skip = options.block_skip;
  channel_.interpreter.optional_stop = options.optional_stop;
  channel_.interpreter.dialect =
      options.dialect == Dialect::fanuc ? ipr::Dialect::fanuc : ipr::Dialect::linuxcnc;
  for (const auto& constraint : options.constraints) {
    constraints_.push_back(std::make_unique<CustomConstraint>(constraint));
    channel_.constraints.push_back(constraints_.back().get());
  }
  if (program == nullptr) return;
  channel_.interpreter.folder = program->folder();
  channel_.interpreter.called = &program->called();
}

}  // namespace softcnc::api
