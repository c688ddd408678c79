// SPDX-License-Identifier: MIT
#include "report/gzip.hpp"

#define ZLIB_CONST  // its input is not changed
#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <new>

namespace softcnc::app {
namespace {

constexpr int kLevel = 6;
constexpr int kGzip = 16;  // added to the bits of the window
constexpr int kWindowBits = 15, kMemory = 9;
constexpr std::size_t kPiece = std::size_t{1} << 20U;

class Deflater {
 public:
  Deflater() {
    if (::deflateInit2(&stream_, kLevel, Z_DEFLATED, kWindowBits + kGzip, kMemory,
                       Z_DEFAULT_STRATEGY) != Z_OK)
      throw std::bad_alloc();
  }
  Deflater(const Deflater&) = delete;
  Deflater& operator=(const Deflater&) = delete;
  ~Deflater() { ::deflateEnd(&stream_); }

  /// Takes a piece, the last one with Z_FINISH.
  void add(std::string_view piece, int flush, std::string& out) {
    std::string buffer(kPiece, '\0');
    stream_.next_in = reinterpret_cast<const Bytef*>(piece.data());
    stream_.avail_in = static_cast<uInt>(piece.size());
    do {
      stream_.next_out = reinterpret_cast<Bytef*>(buffer.data());
      stream_.avail_out = static_cast<uInt>(buffer.size());
      ::deflate(&stream_, flush);
      out.append(buffer, 0, buffer.size() - stream_.avail_out);
    } while (stream_.avail_out == 0);
  }

 private:
  z_stream stream_{};
};

}  // namespace

std::string gzip(std::string_view bytes) {
  Deflater deflater;
  std::string out;
  while (bytes.size() > kPiece) {
    deflater.add(bytes.substr(0, kPiece), Z_NO_FLUSH, out);
    bytes.remove_prefix(kPiece);
  }
  deflater.add(bytes, Z_FINISH, out);
  return out;
}

std::string base64_of(std::string_view bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8U | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      text.push_back(k <= count ? kDigits[group >> (18U - 6U * k) & 63U] : '=');
  }
  return text;
}

}  // namespace softcnc::app
