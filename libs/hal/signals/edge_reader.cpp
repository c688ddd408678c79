// SPDX-License-Identifier: MIT
// Which form a list of edges has; and the binary one.
#include "hal/signals/edge_reader.hpp"

#include <limits>
#include <utility>

#include "hal/signals/edge_format.hpp"
#include "hal/signals/vcd_reader.hpp"

namespace softcnc::hal {
namespace {

constexpr std::string_view kForm = "edges ";

Status edge_failure(std::string why) {
  return tl::make_unexpected(Diagnostic{.code = Code::SC6091, .message = std::move(why)});
}

class BinaryReader final : public EdgeParser {
 public:
  explicit BinaryReader(VisitEdge visit) : visit_(std::move(visit)) {}

  Status read(std::string_view bytes) override {
    for (const char c : bytes) {
      ++bytes_;
      const auto byte = static_cast<unsigned char>(c);
      if (is_line_ ? !take_line(byte) : !take_time(byte)) return damaged();
    }
    return {};
  }

  Status finish() override {
    if (is_line_ || shift_ > 0) return edge_failure("not whole: it ends within an edge");
    return {};
  }

 private:
  Status damaged() const {
    return edge_failure("damaged: byte " + std::to_string(bytes_) +
                        (is_line_ ? " names no line" : " makes no time"));
  }

  bool take_line(unsigned byte) {
    if (byte >= kLineNumbers) return false;
    visit_({edge_of(byte, time_, byte & 1U), {}, {}});
    is_line_ = false;
    return true;
  }

  /// 7 bits of the time since the edge before.
  bool take_time(unsigned byte) {
    constexpr unsigned kBits = 7;
    if (shift_ > 56) return false;
    since_ |= static_cast<std::int64_t>(byte & (kMore - 1)) << shift_;
    shift_ += kBits;
    if (byte >= kMore) return true;
    if (since_ > std::numeric_limits<std::int64_t>::max() - time_) return false;
    time_ += std::exchange(since_, 0);
    shift_ = 0;
    is_line_ = true;
    return true;
  }

  VisitEdge visit_;
  std::int64_t bytes_ = static_cast<std::int64_t>(kBinaryHead.size());
  std::int64_t time_ = 0, since_ = 0;
  unsigned shift_ = 0;
  bool is_line_ = false;
};

}  // namespace

Status EdgeReader::read(std::string_view bytes) {
  if (form_) return form_->read(bytes);
  head_ += bytes;
  return head_.size() < kBinaryHead.size() ? Status() : begin();
}

/// Goes by how the file begins.
Status EdgeReader::begin() {
  if (head_.starts_with(kBinaryHead)) {
    form_ = std::make_unique<BinaryReader>(visit_);
    return form_->read(std::string_view(head_).substr(kBinaryHead.size()));
  }
  if (head_.starts_with(kForm))
    return edge_failure("a list of edges, but not of form 1, the only one this version reads");
  const auto first = head_.find_first_not_of(" \t\r\n");
  if (first != head_.npos && head_[first] != '$')
    return edge_failure("neither a Value Change Dump nor a list that begins with 'edges 1'");
  form_ = std::make_unique<VcdReader>(visit_);
  return form_->read(head_);
}

Status EdgeReader::finish() {
  if (form_) return form_->finish();
  if (head_.empty()) return edge_failure("empty");
  if (auto begun = begin(); !begun) return begun;
  return form_->finish();
}

std::optional<std::vector<SignalEdge>> read_edges(std::string_view bytes) {
  std::vector<SignalEdge> edges;
  EdgeReader reader([&](const ReadEdge& read) {
    if (!read.begins || read.edge.high) edges.push_back(read.edge);
  });
  if (!reader.read(bytes) || !reader.finish()) return std::nullopt;
  return edges;
}

}  // namespace softcnc::hal
