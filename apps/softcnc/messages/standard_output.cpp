// SPDX-License-Identifier: MIT
#include "messages/standard_output.hpp"

#include <utility>

#include "messages/messages.hpp"

namespace softcnc::app {
namespace {

constexpr std::size_t kBuffer = 65536;  // bytes

}  // namespace

[[gnu::hot]] void StandardOutput::write(std::string_view text) {
  buffer_ += text;
  if (buffer_.size() >= kBuffer) flush();
}

void StandardOutput::flush() {
  if (buffer_.empty()) return;
  if (!file_ && status_) {
    auto opened = hal::OutputFile::open("-");
    if (opened)
      file_ = std::move(*opened);
    else
      status_ = tl::make_unexpected(std::move(opened.error()));
  }
  if (status_) status_ = file_->write(buffer_);
  buffer_.clear();
}

int StandardOutput::finish() {
  flush();
  if (status_ && file_) status_ = file_->finish();
  return status_ ? 0 : failed(status_.error());
}

}  // namespace softcnc::app
