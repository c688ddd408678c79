// SPDX-License-Identifier: MIT
// A limit that softcnc does not know: where the tool goes down into the material, it moves at half
// of the feed. 05_custom_constraint PART
#include <algorithm>
#include <iostream>
#include <limits>
#include <softcnc/softcnc.hpp>

namespace cnc = softcnc;

class HalfFeedDown final : public cnc::Constraint {
 public:
  double largest_speed(const cnc::PathPoint& point) const noexcept override {
    constexpr double kSteep = 0.1;  // of the path, downwards
    if (point.rapid || point.tangent.z() > -kSteep) return std::numeric_limits<double>::infinity();
    return 0.5 * point.feed;
  }
};

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  const auto program = cnc::Program::open(argv[1]);
  if (!program) return 2;
  cnc::RunOptions options;
  const auto plain = cnc::plan(*program, cnc::Machine(), options);
  options.constraints.push_back(std::make_shared<HalfFeedDown>());
  const auto careful = cnc::plan(*program, cnc::Machine(), options);
  if (!plain || !careful) return 1;
  double down = 0, level = 0, z = 0;
  careful->for_each_setpoint([&](const cnc::Setpoint& setpoint) {
    double& fastest = setpoint.position.z() < z ? down : level;
    if (setpoint.feed > 0) fastest = std::max(fastest, setpoint.v);
    z = setpoint.position.z();
    return true;
  });
  std::cout << "without " << plain->duration() << " s, with " << careful->duration()
            << " s; fastest down " << down << " mm/s, otherwise " << level << " mm/s\n";
}
