// SPDX-License-Identifier: MIT
// The only file that knows libzstd.
#include "hal/files/zstd_sink.hpp"

#include <zstd.h>

#include <string>
#include <utility>

namespace softcnc::hal {
namespace {

constexpr int kLevel = 3;

class ZstdSink final : public ByteSink {
 public:
  explicit ZstdSink(std::unique_ptr<ByteSink> out)
      : out_(std::move(out)),
        stream_(ZSTD_createCCtx(), ZSTD_freeCCtx),
        compressed_(ZSTD_CStreamOutSize(), '\0') {
    ZSTD_CCtx_setParameter(stream_.get(), ZSTD_c_compressionLevel, kLevel);
    ZSTD_CCtx_setParameter(stream_.get(), ZSTD_c_checksumFlag, 1);
  }

  Status write(std::string_view bytes) override { return pump(bytes, ZSTD_e_continue); }

  Status finish() override {
    if (auto pumped = pump({}, ZSTD_e_end); !pumped) return pumped;
    return out_->finish();
  }

 private:
  Status pump(std::string_view bytes, ZSTD_EndDirective directive) {
    ZSTD_inBuffer in{bytes.data(), bytes.size(), 0};
    for (bool done = false; !done;) {
      ZSTD_outBuffer out{compressed_.data(), compressed_.size(), 0};
      const std::size_t left = ZSTD_compressStream2(stream_.get(), &out, &in, directive);
      if (ZSTD_isError(left))
        return tl::make_unexpected(
            Diagnostic{.code = Code::SC6012,
                       .message = std::string("compressing failed: ") + ZSTD_getErrorName(left)});
      if (auto written = out_->write({compressed_.data(), out.pos}); !written) return written;
      done = directive == ZSTD_e_end ? left == 0 : in.pos == in.size;
    }
    return {};
  }

  std::unique_ptr<ByteSink> out_;
  std::unique_ptr<ZSTD_CCtx, std::size_t (*)(ZSTD_CCtx*)> stream_;
  std::string compressed_;
};

}  // namespace

std::unique_ptr<ByteSink> zstd_sink(std::unique_ptr<ByteSink> out) {
  return std::make_unique<ZstdSink>(std::move(out));
}

}  // namespace softcnc::hal
