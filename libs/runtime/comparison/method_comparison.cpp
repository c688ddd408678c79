// SPDX-License-Identifier: MIT
#include "runtime/comparison/method_comparison.hpp"

#include <fmt/format.h>

#include <cassert>
#include <string>
#include <utility>

#include "hal/backends/backend.hpp"
#include "hal/machine/machine_file.hpp"
#include "runtime/comparison/compared_figure.hpp"
#include "runtime/run/run.hpp"

namespace softcnc::runtime {
namespace {

/// The machine with the method, and with the simulated mill in place of what moves a real one, or
/// why they do not fit each other.
Result<Machine> simulated(const Machine& machine, Method method) {
  const bool moves_nothing = machine.control.backend == BackendKind::none;
  const std::string settings[] = {
      "control.interpolation=" + std::string(name(method)),
      moves_nothing ? std::string("control.backend=none") : std::string("control.backend=sim")};
  auto changed = hal::parse_machine(hal::machine_toml(machine), machine.name, settings);
  if (changed) return *std::move(changed);
  Diagnostic error = std::move(changed.error().front());
  error.pos = {};  // of a text that nobody has written
  return tl::make_unexpected(std::move(error));
}

}  // namespace

MethodComparison::MethodComparison(Program& program, const Machine& machine, ChannelOptions options,
                                   Method method, int phases)
    : program_(program),
      options_(std::move(options)),
      phases_(phases),
      values_(compared_figures().size()) {
  assert(phases > 0);
  auto changed = simulated(machine, method);
  if (changed)
    machine_ = *std::move(changed);
  else
    error_ = std::move(changed.error());
  stopped_ = error_.has_value();
}

bool MethodComparison::run_next(Watcher* watcher) {
  if (next_ == phases_ || stopped_) return false;
  Outcome outcome;
  const double delay = machine_.control.period * next_++ / phases_;
  run(watcher, delay, outcome);
  stopped_ = error_ || outcome.end != Outcome::End::done;
  outcome.time -= delay;
  for (std::size_t i = 0; !stopped_ && i < values_.size(); ++i)
    if (const auto value = compared_figures()[i].value(outcome, machine_))
      values_[i].push_back(*value);
  return true;
}

void MethodComparison::run(Watcher* watcher, double delay, Outcome& outcome) {
  auto backend = hal::open_backend(machine_);
  if (!backend) {
    error_ = std::move(backend.error());
    return;
  }
  options_.first_cut_delay = delay;
  JudgedRun judged = runtime::run({program_, machine_, options_, **backend, nullptr, watcher},
                                  [this](const Diagnostic& diagnostic) {
                                    if (!error_ && diagnostic.severity() == Severity::error)
                                      error_ = diagnostic;
                                  });
  outcome = std::move(judged.outcome);
}

std::string MethodComparison::note() const {
  if (!error_) return {};
  const std::string code = code_name(error_->code);
  if (error_->pos.line == 0) return fmt::format("{} [{}]", error_->message, code);
  return fmt::format("line {}: {} [{}]", error_->pos.line, error_->message, code);
}

std::vector<std::optional<Spread>> MethodComparison::spreads() const {
  std::vector<std::optional<Spread>> spreads;
  for (const std::vector<double>& values : values_)
    spreads.push_back(values.empty() || stopped_ ? std::nullopt : std::optional(spread_of(values)));
  return spreads;
}

}  // namespace softcnc::runtime
