// SPDX-License-Identifier: MIT
// A limit that softcnc does not know: below Z0 the machine cuts, and moves at half the feed.
// 05_custom_constraint PART
#include <algorithm>
#include <iostream>
#include <limits>
#include <softcnc/softcnc.hpp>

namespace cnc = softcnc::api;

class HalfFeedBelow final : public cnc::Constraint {
 public:
  explicit HalfFeedBelow(double z) : z_(z) {}
  double largest_speed(const cnc::PathPoint& point) const noexcept override {
    if (point.rapid || point.position.z() >= z_) return std::numeric_limits<double>::infinity();
    return 0.5 * point.feed;
  }

 private:
  double z_;  // mm
};

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  const auto program = cnc::Program::open(argv[1]);
  if (!program) return 2;
  cnc::RunOptions options;
  const auto plain = cnc::plan(*program, cnc::Machine(), options);
  options.constraints.push_back(std::make_shared<HalfFeedBelow>(0));
  const auto careful = cnc::plan(*program, cnc::Machine(), options);
  if (!plain || !careful) return 1;
  double fastest = 0;
  bool named = false;
  careful->for_each_setpoint([&](const cnc::Setpoint& setpoint) {
    if (setpoint.position.z() < 0) fastest = std::max(fastest, setpoint.v);
    named = named || setpoint.limit == "custom";
    return true;
  });
  std::cout << "without " << plain->duration() << " s, with " << careful->duration()
            << " s; fastest below Z0: " << fastest << " mm/s"
            << (named ? ", limited by custom" : "") << '\n';
}
