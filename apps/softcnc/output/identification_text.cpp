// SPDX-License-Identifier: MIT
#include "output/identification_text.hpp"

#include <fmt/format.h>

#include <array>
#include <cctype>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "hal/files/axis_name.hpp"
#include "motion/core/units.hpp"
#include "motion/model/servo_figures.hpp"

namespace softcnc::app {
namespace {

using Json = nlohmann::ordered_json;

/// A figure of an axis as it is shown.
struct Figure {
  const char* what;
  const char* unit;
  const char* key;  // of JSON
  double value, uncertainty;
  std::optional<double> described;  // by the machine file, if that has it
};

std::array<Figure, 6> figures(const IdentifiedAxis& axis) {
  const runtime::AxisFit& fit = axis.fit;
  const runtime::AxisFigures described = runtime::figures_of(axis.described);
  return {{{"gain of the position loop", "1/s", "kv_1_s", fit.figures.kv, fit.uncertainty.kv,
            described.kv},
           {"lag of the velocity loop", "ms", "velocity_lag_ms", ms_from_s(fit.lag),
            ms_from_s(fit.lag_uncertainty), ms_from_s(velocity_lag(axis.described))},
           {"torque over inertia", "mm/s2 per V", "torque_over_inertia_mm_s2_v",
            fit.figures.torque_over_inertia, fit.uncertainty.torque_over_inertia,
            described.torque_over_inertia},
           {"friction over inertia", "mm/s2", "friction_over_inertia_mm_s2",
            fit.figures.friction_over_inertia, fit.uncertainty.friction_over_inertia,
            described.friction_over_inertia},
           {"backlash", "um", "backlash_um", um_from_mm(fit.figures.backlash),
            um_from_mm(fit.uncertainty.backlash), um_from_mm(axis.described_backlash)},
           {"delay of the record", "ms", "delay_ms", ms_from_s(fit.delay),
            ms_from_s(fit.delay_uncertainty), std::nullopt}}};
}

std::string name_of(const IdentifiedAxis& axis) {
  std::string name = hal::axis_name(axis.axis);
  name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
  return name;
}

}  // namespace

std::string identification_text(const std::vector<IdentifiedAxis>& axes) {
  std::string text;
  for (const IdentifiedAxis& axis : axes) {
    if (!text.empty()) text += '\n';
    if (!axis.fit.moved) {
      text += name_of(axis) + " does not move: nothing is known of it\n";
      continue;
    }
    text += fmt::format("{:<28}{:>12}{:>12}{:>14}\n", name_of(axis), "measured", "within +-",
                        "machine file");
    for (const Figure& figure : figures(axis)) {
      const std::string what = fmt::format("  {}, {}", figure.what, figure.unit);
      text += std::isfinite(figure.uncertainty)
                  ? fmt::format("{:<38}{:>12.4g}{:>12.2g}", what, figure.value, figure.uncertainty)
                  : fmt::format("{:<38}{:>12}{:>12}", what, "unknown", "");
      text += figure.described ? fmt::format("{:>14.4g}\n", *figure.described)
                               : fmt::format("{:>14}\n", "none");
    }
    if (axis.fit.loop_period != axis.described_loop_period)
      text += fmt::format(
          "  the drive reads its counter every {:.4g} ms, where the machine file has {:.4g} ms\n",
          ms_from_s(axis.fit.loop_period), ms_from_s(axis.described_loop_period));
    text += fmt::format(
        "  the model then differs from the axis by {:.2g} um rms, that of the machine file by "
        "{:.2g} um\n",
        um_from_mm(axis.fit.residual), um_from_mm(axis.fit.before));
  }
  return text;
}

std::string identification_json(const std::vector<IdentifiedAxis>& axes) {
  Json document{{"schema", 1}, {"axes", Json::object()}};
  for (const IdentifiedAxis& axis : axes) {
    Json& own = document["axes"][hal::axis_name(axis.axis)];
    own = Json::object();
    own["moved"] = axis.fit.moved;
    if (!axis.fit.moved) continue;
    for (const Figure& figure : figures(axis)) {
      const bool known = std::isfinite(figure.uncertainty);
      own[figure.key] = known ? Json{{"value", figure.value}, {"uncertainty", figure.uncertainty}}
                              : Json(nullptr);
    }
    own["loop_period_ms"] = ms_from_s(axis.fit.loop_period);
    own["residual_um_rms"] = um_from_mm(axis.fit.residual);
    own["residual_of_machine_file_um_rms"] = um_from_mm(axis.fit.before);
  }
  return document.dump(2) + '\n';
}

}  // namespace softcnc::app
