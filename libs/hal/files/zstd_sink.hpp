// SPDX-License-Identifier: MIT
// Bytes on their way to another sink, compressed by Zstandard.
#pragma once

#include <memory>

#include "hal/files/output_file.hpp"

namespace softcnc::hal {

/// One frame with a checksum, written by one thread: the same bytes in, the same bytes out.
std::unique_ptr<ByteSink> zstd_sink(std::unique_ptr<ByteSink> out);

}  // namespace softcnc::hal
