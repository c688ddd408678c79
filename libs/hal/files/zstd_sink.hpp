// SPDX-License-Identifier: MIT
// A sink that compresses bytes with Zstandard and passes them to another sink.
#pragma once

#include <memory>

#include "hal/files/output_file.hpp"

namespace softcnc::hal {

/// Makes such a sink: one frame with a checksum, the same output for the same input.
std::unique_ptr<ByteSink> zstd_sink(std::unique_ptr<ByteSink> out);

}  // namespace softcnc::hal
