// SPDX-License-Identifier: MIT
// meta.json of a recording.
#pragma once

#include <string>

#include "recording/recording.hpp"

namespace softcnc::app {

/// With a hash of all that it says.
std::string meta_json(const RecordingMeta& meta);

/// No array or object of a meta.json lies deeper.
inline constexpr int kMaxMetaDepth = 16;

/// Puts the hash of a text that is a JSON object right; any other text is returned as it is.
std::string sealed_meta(const std::string& text);

/// Errors: SC6021 (not such a text, another hash, numbers that no run has), SC6022 (another
/// schema); without a file. Schema 1 had no hash of its own.
Result<RecordingMeta> parse_meta(const std::string& text);

}  // namespace softcnc::app
