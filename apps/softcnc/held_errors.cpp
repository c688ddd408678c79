// SPDX-License-Identifier: MIT
#include "held_errors.hpp"

#include <algorithm>
#include <utility>

#include "ipr/repairs.hpp"

namespace softcnc::app {
namespace {

constexpr std::size_t kMostHeld = 100;
constexpr std::size_t kLongestText = 100'000;  // bytes

}  // namespace

HeldErrors::HeldErrors(Program& program, const Machine& machine, const ChannelOptions& options,
                       Messages& messages)
    : program_(program),
      machine_(machine),
      options_(options),
      show_(messages.sink(program)),
      holding_(!program.streamed()) {}

Diagnostics::Sink HeldErrors::sink() {
  return [this](const Diagnostic& diagnostic) { take(diagnostic); };
}

void HeldErrors::take(const Diagnostic& diagnostic) {
  const bool waits = holding_ && (!held_.empty() || diagnostic.severity() == Severity::error);
  if (!waits) return show_(diagnostic);
  held_.push_back(diagnostic);
  if (held_.size() > kMostHeld) show_all();
}

/// From here on they are shown as they come.
void HeldErrors::show_all() {
  for (const Diagnostic& diagnostic : held_) show_(diagnostic);
  held_.clear();
  holding_ = false;
}

void HeldErrors::finish() {
  const auto is_error = [](const Diagnostic& d) { return d.severity() == Severity::error; };
  if (std::count_if(held_.begin(), held_.end(), is_error) < 2) return show_all();
  std::string text = this->text();
  if (text.size() > kLongestText) return show_all();
  const auto follows = ipr::follow_from_others(std::move(text), held_, machine_,
                                               options_.interpreter, options_.state);
  for (std::size_t i = 0; i < held_.size(); ++i)
    if (!follows[i]) show_(held_[i]);
  held_.clear();
}

std::string HeldErrors::text() const {
  std::string text;
  program_.for_each_piece([&](std::string_view piece) {
    if (text.size() <= kLongestText) text += piece;
  });
  return text;
}

}  // namespace softcnc::app
