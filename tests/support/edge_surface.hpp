// SPDX-License-Identifier: MIT
// The surface that edges leave which turn on a ball and feed along passes next to each other, found
// without a model of its roughness: for every point, the lowest instant at which an edge cuts it.
// All lengths are parts of the pick-feed; heights are parts of what passes alone leave, f_p^2 / 8r.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace softcnc::test {

/// Of four passes next to each other, and of those beyond them again.
struct Strewn {
  double aside = 0;                 // of the tool axis, from where the ball touches
  std::array<double, 4> phases{};   // feeds per tooth
  std::array<bool, 4> backwards{};  // against the others
};

/// `feed`: per tooth; `tip`: how far the tool axis stands from where the ball touches, r
/// sin|alpha|. The ball is shallow where it cuts, and edges are rays from the axis. Passes are in
/// phase, if they are not strewn.
class EdgeSurface {
 public:
  /// `stretch`: on a curved surface all lengths are those that make the ball lie over it as
  /// over a flat one; seen from the axis those along the feed are longer than those across by this.
  EdgeSurface(double feed, double tip, int teeth, double stretch = 1)
      : feed_(feed), tip_(tip), share_(teeth / (2 * std::numbers::pi)), stretch_(stretch) {}

  EdgeSurface(double feed, double tip, int teeth, const Strewn& strewn, double stretch = 1)
      : EdgeSurface(feed, tip, teeth, stretch) {
    strewn_ = strewn;
  }

  /// Above the ideal surface at `x` along the feed and `y` across it, from the line of a pass.
  double height(double x, double y) const {
    double least = std::numeric_limits<double>::infinity();
    const double pass = std::floor(y);
    for (const double side : {0.0, 1.0, -1.0, 2.0}) {
      const double dy = y - pass - side;
      if (4 * dy * dy < least)
        least = std::min(least, cut_by_pass(x, dy, static_cast<int>(pass + side) & 3));
    }
    return least;
  }

  /// The highest point of one pick-feed by one feed per tooth.
  double rmax() const {
    std::vector<Place> places;
    for (int i = 0; i < kGrid; ++i)
      for (int j = 0; j < kGrid; ++j)
        places.push_back(place(feed_ * (i + 0.5) / kGrid, (j + 0.5) / kGrid));
    const auto highest = places.begin() + kClimbs;
    std::partial_sort(places.begin(), highest, places.end(),
                      [](const Place& a, const Place& b) { return a.height > b.height; });
    double most = 0;
    for (auto from = places.begin(); from != highest; ++from)
      most = std::max(most, climbed(*from).height);
    return most;
  }

 private:
  struct Place {
    double x, y, height;
  };
  static constexpr int kGrid = 28, kClimbs = 8;
  static constexpr double kOffLine = 1e-9, kFinest = 2e-4;

  Place place(double x, double y) const { return {x, y, height(x, y)}; }

  /// The top of the hill on which a place lies, by steps that halve.
  Place climbed(Place at) const {
    for (double step = 0.5 / kGrid; step > kFinest;) {
      Place best = at;
      for (const double x : {-step, 0.0, step})
        for (const double y : {-step, 0.0, step})
          if (const Place near = place(at.x + x * feed_, at.y + y); near.height > best.height)
            best = near;
      if (best.height > at.height)
        at = best;
      else
        step /= 2;
    }
    return at;
  }

  /// Whole where an edge passes a point that lies `w` before the axis and `dy` beside it, which the
  /// axis was at x - w. One slope between two places of turns().
  double phase(double x, double w, double dy) const {
    return (x - w) / feed_ - share_ * std::atan2(dy, stretch_ * w);
  }

  /// Where the axis passes close, an edge and the point turn about it equally fast twice.
  double turn(double dy) const {
    const double square = dy > 0 ? dy * (feed_ * share_ * stretch_ - dy) : 0;
    return square > 0 ? std::sqrt(square) / stretch_ : 0;
  }

  /// The direction of a pass is that of its edges, except for its phase.
  double cut_by_pass(double x, double dy, int pass) const {
    const auto number = static_cast<std::size_t>(pass);
    const double beside = (strewn_.backwards[number] ? -1 : 1) * (dy + strewn_.aside);
    const double from = x + strewn_.phases[number] * feed_;
    return 4 * (nearest_cut(from, beside == 0 ? kOffLine : beside) + dy * dy);
  }

  double nearest_cut(double x, double dy) const {
    const double far = tip_ + feed_ * (2 + 4 * share_) + 1, close = turn(dy);
    double least = std::numeric_limits<double>::infinity();
    const auto seek = [&](double from, double to) {
      least = std::min(least, cut_between(x, dy, from, to));
    };
    if (close == 0) {
      seek(-far, far);
    } else {
      seek(-far, -close);
      seek(-close, close);
      seek(close, far);
    }
    return least;
  }

  /// The least square distance along the feed from the lowest point of the ball, -tip, to a cut.
  double cut_between(double x, double dy, double from, double to) const {
    const double nearest = std::clamp(-tip_, from, to);
    const double level = phase(x, nearest, dy);
    double least = std::numeric_limits<double>::infinity();
    for (const double whole : {std::floor(level), std::ceil(level)})
      for (const double end : {from, to}) {
        if ((phase(x, end, dy) - whole) * (level - whole) > 0) continue;
        const double w = root(x, dy, nearest, end, whole);
        least = std::min(least, (w + tip_) * (w + tip_));
      }
    return least;
  }

  double root(double x, double dy, double a, double b, double level) const {
    double fa = phase(x, a, dy) - level, fb = phase(x, b, dy) - level;
    for (int i = 0; i < 60 && std::abs(b - a) > 1e-9 && fa != fb; ++i) {  // Illinois
      const double c = (a * fb - b * fa) / (fb - fa);
      const double fc = phase(x, c, dy) - level;
      if (std::abs(fc) < 1e-11) return c;
      if (fc * fb < 0) {
        a = b;
        fa = fb;
      } else {
        fa /= 2;
      }
      b = c;
      fb = fc;
    }
    return b;
  }

  double feed_, tip_;
  double share_;  // teeth / 2 pi
  double stretch_;
  Strewn strewn_;
};

}  // namespace softcnc::test
