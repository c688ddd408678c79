// SPDX-License-Identifier: MIT
// A backend of the user behind the interface of those of softcnc.
#pragma once

#include <memory>
#include <softcnc/backend.hpp>
#include <utility>

#include "api/convert.hpp"
#include "hal/backends/backend.hpp"

namespace softcnc::api {

/// A backend of the user as one of the runtime's.
class CustomBackend final : public hal::Backend {
 public:
  CustomBackend(std::shared_ptr<api::Backend> backend, double period)
      : backend_(std::move(backend)), period_(period) {}

  softcnc::Feedback exchange(const softcnc::Setpoint& setpoint) noexcept override {
    if (!backend_) return {last_, Alarm::driver_fault};
    const api::Feedback feedback = backend_->exchange(setpoint_of(setpoint, period_));
    if (!feedback.position.allFinite()) return {last_, Alarm::driver_fault};
    last_ = feedback.position;
    return {last_, feedback.alarm ? Alarm::driver_fault : Alarm::none, -1, feedback.home};
  }
  bool has_home_switches() const noexcept override {
    return backend_ && backend_->has_home_switches();
  }
  void begin_again() noexcept override {
    if (backend_) backend_->begin_again();
  }
  void rest(const softcnc::Setpoint&) noexcept override {
    if (backend_) backend_->rest();
  }
  softcnc::AxisVector settle() const noexcept override { return last_; }

 private:
  std::shared_ptr<api::Backend> backend_;
  double period_;
  softcnc::AxisVector last_ = softcnc::AxisVector::Zero();
};

}  // namespace softcnc::api
