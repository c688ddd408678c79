// SPDX-License-Identifier: MIT
// Lists of signal edges from files: VCD, or the compact binary form.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hal/signals/step_edges.hpp"
#include "motion/core/result.hpp"

namespace softcnc::hal {

/// An edge with its place in the file.
struct ReadEdge {
  SignalEdge edge;
  SourcePos pos;          // of VCD
  std::string_view line;  // its text; while the edge is visited
  bool begins = false;    // no edge, but the level at which a line begins
};
using VisitEdge = std::function<void(const ReadEdge&)>;

/// A form in which edges stand in a file. Errors: SC6091.
class EdgeParser {
 public:
  virtual ~EdgeParser() = default;
  /// The next piece, cut anywhere.
  virtual Status read(std::string_view bytes) = 0;
  /// Ends the text, after its last piece.
  virtual Status finish() = 0;
};

/// Reads "edges 1\n" and what EdgeWriter writes after it; anything else is read as VCD.
class EdgeReader final : public EdgeParser {
 public:
  explicit EdgeReader(VisitEdge visit) : visit_(std::move(visit)) {}

  Status read(std::string_view bytes) override;
  Status finish() override;

 private:
  Status begin();

  VisitEdge visit_;
  std::string head_;
  std::unique_ptr<EdgeParser> form_;
};

/// Returns the edges of a file from its bytes; nothing if it is not a list of edges.
std::optional<std::vector<SignalEdge>> read_edges(std::string_view bytes);

}  // namespace softcnc::hal
