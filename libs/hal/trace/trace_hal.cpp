// SPDX-License-Identifier: MIT
#include "hal/trace/trace_hal.hpp"

#include <utility>

#include "hal/backends/stream_rows.hpp"
#include "hal/files/file_piece.hpp"
#include "hal/signals/commands.hpp"

namespace softcnc::hal {
namespace {

class HalTrace final : public TraceWriter {
 public:
  HalTrace(std::unique_ptr<ByteSink> out, const Machine& machine)
      : out_(std::move(out)),
        commands_(machine),
        rows_(machine, kFilePiece),
        status_(out_->write(rows_.head())) {}

  void row(const Setpoint& setpoint, std::span<const double> /*backend_values*/) noexcept override {
    send(commands_(setpoint));
  }

  void rest(const Setpoint& at) noexcept override {
    if (!rows_.started()) return;
    send(commands_.rest(at));
    rows_.rest();
  }

  void flush() noexcept override {
    if (ok()) status_ = out_->write(rows_.bytes());
    rows_.pass();
  }

  void add_program_hash(const std::string& /*hash*/) override {}
  bool ok() const noexcept override { return status_.has_value(); }

  Status finish() override {
    while (const Setpoint* sent = ok() ? commands_.next_to_release() : nullptr) send(*sent);
    rows_.end();
    flush();
    if (ok()) status_ = out_->write(rows_.tail());
    if (ok()) status_ = out_->finish();
    return status_;
  }

 private:
  void send(const Setpoint& sent) noexcept {
    if (!ok()) return;
    rows_.add(sent);
    if (rows_.bytes().size() >= kFilePiece) flush();
  }

  std::unique_ptr<ByteSink> out_;
  Commands commands_;
  StreamRows rows_;
  Status status_;
};

}  // namespace

std::unique_ptr<TraceWriter> hal_trace(std::unique_ptr<ByteSink> out, const TraceHeader& /*header*/,
                                       const Machine& machine,
                                       std::span<const std::string> /*backend_columns*/) {
  return std::make_unique<HalTrace>(std::move(out), machine);
}

}  // namespace softcnc::hal
