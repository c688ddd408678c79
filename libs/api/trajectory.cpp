// SPDX-License-Identifier: MIT
#include <algorithm>
#include <softcnc/trajectory.hpp>
#include <utility>
#include <vector>

#include "api/convert.hpp"
#include "api/data.hpp"
#include "hal/backends/backend.hpp"
#include "ipo/planner/planner.hpp"
#include "runtime/check/check.hpp"
#include "runtime/program/each_block.hpp"
#include "runtime/run/run.hpp"

namespace softcnc::api {

struct Trajectory::Data {
  runtime::Program* program;
  softcnc::Machine machine;
  RunOptions options;
  std::vector<ipo::TimedBlock> blocks;
  std::vector<softcnc::AxisVector> rests;  // mm: where the machine is before each block

  void add(ipo::TimedBlock block) {
    const Move* move = block.move();
    if (move != nullptr && rests.empty()) place = softcnc::start(move->path);
    rests.push_back(place);
    if (move != nullptr) place = softcnc::end(move->path);
    blocks.push_back(std::move(block));
  }
  softcnc::AxisVector place = softcnc::AxisVector::Zero();
};

namespace {

/// Hands setpoints on until no more are wanted.
class Visits final : public runtime::RowSink {
 public:
  Visits(const std::function<bool(const Setpoint&)>& visit, double period)
      : visit_(visit), period_(period) {}
  bool row(const softcnc::Setpoint& setpoint, std::span<const double>) override {
    return visit_(setpoint_of(setpoint, period_));
  }

 private:
  const std::function<bool(const Setpoint&)>& visit_;
  double period_;
};

Motion motion_in(const ipo::TimedBlock& block, const softcnc::AxisVector& rest, double t) {
  std::size_t hint = 0;
  const ipo::State state = block.profile.at(t - block.t_start, hint);
  const ipo::Mark mark = block.at(state.s);
  Motion motion;
  motion.s = block.s_start + state.s;
  motion.v = state.v;
  motion.a = state.a;
  motion.position = rest;
  motion.line = mark.source.line;
  motion.block = mark.number;
  motion.limit = softcnc::name(state.limit);
  const Move* move = block.move();
  if (move == nullptr) return motion;
  const softcnc::PathPoint point = softcnc::at(move->path, state.s);
  motion.position = softcnc::position(move->path, state.s);
  motion.velocity = point.dq * state.v;
  motion.acceleration = point.ddq * (state.v * state.v) + point.dq * state.a;
  return motion;
}

std::vector<Diagnostic> errors_of(std::vector<Diagnostic> all) {
  std::erase_if(all, [](const Diagnostic& one) { return one.severity != Severity::error; });
  return all;
}

}  // namespace

Trajectory::Trajectory(std::unique_ptr<Data> data) noexcept : data_(std::move(data)) {}
Trajectory::Trajectory(Trajectory&& other) noexcept = default;
Trajectory& Trajectory::operator=(Trajectory&& other) noexcept = default;
Trajectory::~Trajectory() = default;

double Trajectory::duration() const noexcept {
  return data_->blocks.empty() ? 0 : data_->blocks.back().t_end();
}

double Trajectory::length() const noexcept {
  for (auto block = data_->blocks.rbegin(); block != data_->blocks.rend(); ++block)
    if (const Move* move = block->move()) return block->s_start + softcnc::length(move->path);
  return 0;
}

Motion Trajectory::at(double t) const noexcept {
  const auto& blocks = data_->blocks;
  if (blocks.empty()) return {};
  t = std::clamp(t, 0.0, duration());
  const auto later =
      std::upper_bound(blocks.begin(), blocks.end(), t,
                       [](double a, const ipo::TimedBlock& block) { return a < block.t_start; });
  const auto found = later == blocks.begin() ? later : later - 1;
  return motion_in(*found, data_->rests[static_cast<std::size_t>(found - blocks.begin())], t);
}

void Trajectory::for_each_setpoint(const std::function<bool(const Setpoint&)>& visit) const {
  runtime::Program& program = *data_->program;
  const softcnc::Machine machine = runtime::without_backend(data_->machine);
  const auto backend = hal::open_backend(machine);
  if (!backend) return;
  const RunSetup setup(data_->options, &program);
  Visits visits(visit, machine.control.period);
  runtime::run({.program = program,
                .machine = machine,
                .options = setup.channel(),
                .backend = **backend,
                .rows = &visits,
                .is_judged = false},
               [](const softcnc::Diagnostic&) {});
}

Expected<Trajectory> plan(const Program& program, const Machine& machine,
                          const RunOptions& options) {
  if (auto errors = errors_of(check(program, machine, options)); !errors.empty()) return errors;
  auto data = std::make_unique<Trajectory::Data>();
  data->program = &program.data().program;
  data->machine = machine.data().machine;
  data->options = options;
  const RunSetup setup(options, data->program);
  Diagnostics silent([](const softcnc::Diagnostic&) {});
  ipr::Reader reader = data->program->reader();
  ipr::Parser parser(reader, silent);
  ipr::Interpreter interpreter(parser, data->machine, silent, setup.channel().interpreter,
                               setup.channel().state);
  ipo::Planner planner(data->machine, setup.channel().feed_override, silent, {},
                       setup.channel().constraints);
  const auto take = [&](const Block& block) {
    planner.push(block);
    while (auto timed = planner.pop()) data->add(std::move(*timed));
    return true;
  };
  runtime::each_block(interpreter, take, [] { return false; });
  planner.finish();
  while (auto timed = planner.pop()) data->add(std::move(*timed));
  return Trajectory(std::move(data));
}

}  // namespace softcnc::api
