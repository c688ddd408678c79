// SPDX-License-Identifier: MIT
// The benchmark curves in tests/data.
#pragma once

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "motion/geometry/nurbs.hpp"

namespace softcnc::test {

/// The specification of tests/data/<name>.json: butterfly, circle_deg2 or infinity8.
inline NurbsSpec curve_spec(const std::string& name) {
  std::ifstream file(std::string(SOFTCNC_SOURCE_DIR) + "/tests/data/" + name + ".json");
  const auto json = nlohmann::json::parse(file);
  NurbsSpec spec;
  spec.degree = json["degree"];
  for (const auto& p : json["control_points"])
    spec.control.emplace_back(p[0].get<double>(), p[1].get<double>(), 0.0);
  spec.weights = json["weights"].get<std::vector<double>>();
  spec.knots = json["knots"].get<std::vector<double>>();
  return spec;
}

inline Nurbs curve(const std::string& name) { return Nurbs::make(curve_spec(name)).value(); }

}  // namespace softcnc::test
