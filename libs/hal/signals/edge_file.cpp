// SPDX-License-Identifier: MIT
#include "hal/signals/edge_file.hpp"

#include "hal/files/file_piece.hpp"
#include "hal/signals/edge_format.hpp"

namespace softcnc::hal {
namespace {

/// How VCD calls a line: one printable character.
constexpr char vcd_name_of_line(unsigned line) noexcept {
  return static_cast<char>('!' + line / 2);
}

class VcdFormat final : public EdgeFormat {
 public:
  std::string head() const override {
    std::string text = "$timescale 1 ns $end\n$scope module softcnc $end\n";
    std::string zeros;
    for (unsigned line = 0; line < kLineNumbers; line += 2) {
      text +=
          std::string("$var wire 1 ") + vcd_name_of_line(line) + ' ' + line_name(line) + " $end\n";
      zeros += std::string("0") + vcd_name_of_line(line) + '\n';
    }
    return text + "$upscope $end\n$enddefinitions $end\n#0\n$dumpvars\n" + zeros + "$end\n";
  }

  void append(const SignalEdge& edge, std::string& bytes) override {
    if (edge.time != time_) bytes += '#' + std::to_string(edge.time) + '\n';
    time_ = edge.time;
    bytes += edge.high ? '1' : '0';
    bytes += vcd_name_of_line(line_of(edge));
    bytes += '\n';
  }

 private:
  std::int64_t time_ = 0;
};

class BinaryFormat final : public EdgeFormat {
 public:
  std::string head() const override { return std::string(kBinaryHead); }

  void append(const SignalEdge& edge, std::string& bytes) override {
    auto since = static_cast<std::uint64_t>(edge.time - time_);
    time_ = edge.time;
    for (; since >= kMore; since >>= 7U) bytes += static_cast<char>((since & 0x7FU) | kMore);
    bytes += static_cast<char>(since);
    bytes += static_cast<char>(line_of(edge) + (edge.high ? 1U : 0U));
  }

 private:
  std::int64_t time_ = 0;
};

std::unique_ptr<EdgeFormat> edge_format_of(std::string_view file) {
  if (file.ends_with(".vcd")) return std::make_unique<VcdFormat>();
  if (file.ends_with(".edges")) return std::make_unique<BinaryFormat>();
  return nullptr;
}

}  // namespace

EdgeWriter::EdgeWriter(std::unique_ptr<EdgeFormat> format, std::unique_ptr<ByteSink> out)
    : format_(std::move(format)), out_(std::move(out)), bytes_(format_->head()) {}

Result<EdgeWriter> EdgeWriter::open(const std::string& file) {
  auto format = edge_format_of(file);
  if (!format)
    return tl::make_unexpected(Diagnostic{
        .code = Code::SC6050, .message = "a list of edges ends in .vcd or .edges", .file = file});
  auto out = OutputFile::open(file);
  if (!out) return tl::make_unexpected(std::move(out.error()));
  return EdgeWriter(std::move(format), std::move(*out));
}

EdgeWriter EdgeWriter::vcd(std::unique_ptr<ByteSink> out) {
  return {std::make_unique<VcdFormat>(), std::move(out)};
}

Alarm EdgeWriter::take(std::span<const SignalEdge> edges, std::int64_t /*until*/) noexcept {
  if (!ok()) return Alarm::port;
  for (const SignalEdge& edge : edges) format_->append(edge, bytes_);
  if (bytes_.size() >= kFilePiece) hand_on();
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

}  // namespace softcnc::hal
