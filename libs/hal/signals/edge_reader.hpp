// SPDX-License-Identifier: MIT
// Lists of edges out of files, whoever wrote them: VCD, or the compact binary form.
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
  Edge edge;
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
  /// After the last piece.
  virtual Status finish() = 0;
};

/// "edges 1\n" and what EdgeWriter writes behind it; anything else is taken for VCD.
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

/// The edges of a file, by its text; nothing if it is no list of edges.
std::optional<std::vector<Edge>> read_edges(std::string_view bytes);

}  // namespace softcnc::hal
