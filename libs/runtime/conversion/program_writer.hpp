// SPDX-License-Identifier: MIT
// Blocks as the lines of a part program.
#pragma once

#include <optional>
#include <string>

#include "runtime/conversion/conversion.hpp"

namespace softcnc::runtime {

class ProgramWriter {
 public:
  using Write = std::function<void(std::string_view)>;

  /// All must outlive the writer, which begins the program.
  ProgramWriter(const Machine& machine, CurveForm form, double tolerance, const Write& write);

  void write(const Block& block);
  const ConversionCounts& counts() const noexcept { return counts_; }

 private:
  void write(const Move& move);
  void write(const Dwell& dwell);
  void write(const Action& action);
  void write_line(const AxisVector& to, bool rapid);
  void write_arc(const Arc& arc);
  void write_nurbs(const Nurbs& curve);
  void write_splines(const Nurbs& curve);
  void write_chords(const Path& path);
  void write_biarcs(const Path& path);
  void set_modes(const Move& move);
  void set_surface(std::optional<Surface> surface);
  std::string words(const AxisVector& to) const;
  void add(std::string_view line);

  const Machine& machine_;
  CurveForm form_;
  double tolerance_;
  std::string follow_;  // G61 or G64
  const Write& write_;
  PathMode mode_ = PathMode::follow;
  double feed_ = 0;        // mm/min
  std::string feed_word_;  // that the next line needs
  std::optional<Surface> surface_;
  ConversionCounts counts_;
};

}  // namespace softcnc::runtime
