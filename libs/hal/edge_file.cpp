// SPDX-License-Identifier: MIT
#include "hal/edge_file.hpp"

#include <charconv>

#include "hal/axis_name.hpp"

namespace softcnc::hal {
namespace {

constexpr std::size_t kHandOn = 1U << 16U;  // bytes
constexpr std::string_view kBinaryHead = "edges 1\n";
constexpr unsigned kMore = 0x80;

/// The number of a line: 4 axis + 2 for its direction, as in the binary form.
constexpr unsigned line_of(const Edge& edge) noexcept {
  return 4U * edge.axis + (edge.wire == Wire::direction ? 2U : 0U);
}
Edge edge_of(unsigned line, std::int64_t time, bool high) noexcept {
  return {time, static_cast<std::uint8_t>(line / 4), line & 2U ? Wire::direction : Wire::step,
          high};
}
constexpr unsigned kLines = 4 * kAxes;

/// How VCD calls a line: one printable character.
constexpr char vcd_name(unsigned line) noexcept { return static_cast<char>('!' + line / 2); }

class Vcd final : public EdgeFormat {
 public:
  std::string head() const override {
    std::string text = "$timescale 1 ns $end\n$scope module softcnc $end\n";
    std::string zeros;
    for (unsigned line = 0; line < kLines; line += 2) {
      const auto* wire = line & 2U ? "_direction" : "_step";
      const auto axis = axis_name(static_cast<int>(line / 4));
      text += std::string("$var wire 1 ") + vcd_name(line) + ' ' + axis + wire + " $end\n";
      zeros += std::string("0") + vcd_name(line) + '\n';
    }
    return text + "$upscope $end\n$enddefinitions $end\n#0\n$dumpvars\n" + zeros + "$end\n";
  }

  void append(const Edge& edge, std::string& bytes) override {
    if (edge.time != time_) bytes += '#' + std::to_string(edge.time) + '\n';
    time_ = edge.time;
    bytes += edge.high ? '1' : '0';
    bytes += vcd_name(line_of(edge));
    bytes += '\n';
  }

 private:
  std::int64_t time_ = 0;
};

class Binary final : public EdgeFormat {
 public:
  std::string head() const override { return std::string(kBinaryHead); }

  void append(const Edge& edge, std::string& bytes) override {
    auto since = static_cast<std::uint64_t>(edge.time - time_);
    time_ = edge.time;
    for (; since >= kMore; since >>= 7U) bytes += static_cast<char>((since & 0x7FU) | kMore);
    bytes += static_cast<char>(since);
    bytes += static_cast<char>(line_of(edge) + (edge.high ? 1U : 0U));
  }

 private:
  std::int64_t time_ = 0;
};

std::unique_ptr<EdgeFormat> format_of(std::string_view file) {
  if (file.ends_with(".vcd")) return std::make_unique<Vcd>();
  if (file.ends_with(".edges")) return std::make_unique<Binary>();
  return nullptr;
}

std::optional<std::vector<Edge>> read_binary(std::string_view bytes) {
  std::vector<Edge> edges;
  std::int64_t time = 0;
  std::uint64_t since = 0;
  unsigned shift = 0;
  bool is_line = false;
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    if (is_line) {
      if (byte >= kLines) return std::nullopt;
      time += static_cast<std::int64_t>(since);
      edges.push_back(edge_of(byte, time, byte & 1U));
      since = 0;
      shift = 0;
      is_line = false;
      continue;
    }
    if (shift > 56) return std::nullopt;
    since |= static_cast<std::uint64_t>(byte & 0x7FU) << shift;
    shift += 7;
    is_line = byte < kMore;
  }
  if (is_line || shift > 0) return std::nullopt;
  return edges;
}

/// One line of VCD behind its definitions. False if it is none.
bool read_vcd_line(std::string_view line, std::int64_t& time, std::vector<Edge>& edges) {
  if (line.starts_with('#')) {
    const auto [end, error] = std::from_chars(line.data() + 1, line.data() + line.size(), time);
    return error == std::errc{} && end == line.data() + line.size();
  }
  const bool is_level = line.size() == 2 && (line[0] == '0' || line[0] == '1');
  const unsigned wire = is_level ? 2 * static_cast<unsigned>(line[1] - '!') : kLines;
  if (wire >= kLines) return false;
  edges.push_back(edge_of(wire, time, line[0] == '1'));
  return true;
}

std::optional<std::vector<Edge>> read_vcd(std::string_view text) {
  std::vector<Edge> edges;
  std::int64_t time = 0;
  while (!text.empty()) {
    const auto end = text.find('\n');
    if (end == text.npos || !read_vcd_line(text.substr(0, end), time, edges)) return std::nullopt;
    text.remove_prefix(end + 1);
  }
  return edges;
}

}  // namespace

EdgeWriter::EdgeWriter(std::unique_ptr<EdgeFormat> format, std::unique_ptr<ByteSink> out)
    : format_(std::move(format)), out_(std::move(out)), bytes_(format_->head()) {}

Result<EdgeWriter> EdgeWriter::open(const std::string& file) {
  auto format = format_of(file);
  if (!format)
    return tl::make_unexpected(
        Diagnostic{Code::SC6050, {}, "a list of edges ends in .vcd or .edges", file, {}});
  auto out = OutputFile::open(file);
  if (!out) return tl::make_unexpected(std::move(out.error()));
  return EdgeWriter(std::move(format), std::move(*out));
}

EdgeWriter EdgeWriter::vcd(std::unique_ptr<ByteSink> out) {
  return {std::make_unique<Vcd>(), std::move(out)};
}

Alarm EdgeWriter::take(std::span<const Edge> edges, std::int64_t /*until*/) noexcept {
  if (!ok()) return Alarm::port;
  for (const Edge& edge : edges) format_->append(edge, bytes_);
  if (bytes_.size() >= kHandOn) hand_on();
  return ok() ? Alarm::none : Alarm::port;
}

void EdgeWriter::hand_on() {
  status_ = out_->write(bytes_);
  bytes_.clear();
}

Status EdgeWriter::finish() {
  if (ok()) hand_on();
  if (ok()) status_ = out_->finish();
  return status_;
}

std::optional<std::vector<Edge>> read_edges(std::string_view bytes) {
  if (bytes.starts_with(kBinaryHead)) return read_binary(bytes.substr(kBinaryHead.size()));
  const std::string head = Vcd().head();
  if (bytes.starts_with(head)) return read_vcd(bytes.substr(head.size()));
  return std::nullopt;
}

}  // namespace softcnc::hal
