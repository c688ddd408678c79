// SPDX-License-Identifier: MIT
#include "ipo/rebuild/ties.hpp"

#include <algorithm>
#include <cmath>

#include "ipo/tuning.hpp"

namespace softcnc::ipo {
namespace {

class WindowTies {
 public:
  WindowTies(const TubeWindow& window, const Guide& guide) : window_(window), guide_(guide) {
    const QuinticSpline& spline = window.spline;
    const double t0 = spline.begin(window.first_span), t1 = spline.end(spline.spans() - 1);
    for (std::size_t line = guide.line_at(t0); line + 1 < guide.vertices().size(); ++line) {
      if (guide.vertices()[line].t >= t1) break;
      add_line(line, t0, t1);
    }
    for (std::size_t i = 0; i < ties_.size(); ++i) {
      const double before = i == 0 ? t0 : 0.5 * (ties_[i - 1].t + ties_[i].t);
      const double after = i + 1 == ties_.size() ? t1 : 0.5 * (ties_[i].t + ties_[i + 1].t);
      ties_[i].weight = after - before;
    }
  }

  const std::vector<Tie>& ties() const noexcept { return ties_; }

 private:
  void add_line(std::size_t line, double t0, double t1) {
    const GuideVertex& v = guide_.vertices()[line];
    const double end = guide_.end_of(line), length = end - v.t;
    if (v.t > t0 && v.turn > 0) add(v.t, line, true);
    const std::size_t span = window_.spline.span_at(std::clamp(v.t + 0.5 * length, t0, t1));
    const double width = window_.spline.end(span) - window_.spline.begin(span);
    if (length < tuning::rebuild::kFewTies * width) return;
    const auto parts = std::min(1000.0, std::ceil(length / (tuning::rebuild::kTies * width)));
    for (double i = 0.5; i < parts; ++i) {
      const double t = v.t + i / parts * length;
      if (t > t0 && t < t1) add(t, line, false);
    }
  }

  void add(double t, std::size_t line, bool vertex) {
    const auto& vertices = guide_.vertices();
    const GuideVertex& v = vertices[line];
    Tie tie{t, window_.spline.span_at(t), line, vertex, v.at(t), v.direction, v.tolerance, 0, 0};
    tie.slip = guide_.slip(line);
    if (vertex) {
      tie.tangent = (v.direction + vertices[line - 1].direction).normalized();
      tie.tolerance = std::min(v.tolerance, vertices[line - 1].tolerance);
      tie.slip = std::min(tie.slip, guide_.slip(line - 1));
    }
    ties_.push_back(tie);
  }

  const TubeWindow& window_;
  const Guide& guide_;
  std::vector<Tie> ties_;
};

}  // namespace

std::vector<Tie> ties_of(const TubeWindow& window, const Guide& guide) {
  return WindowTies(window, guide).ties();
}

}  // namespace softcnc::ipo
