// SPDX-License-Identifier: MIT
// meta.json of a recording.
#pragma once

#include <string>

#include "recording.hpp"

namespace softcnc::app {

std::string meta_json(const RecordingMeta& meta);

/// Errors: SC6021 (not such a text), SC6022 (another schema); without a file.
Result<RecordingMeta> parse_meta(const std::string& text);

}  // namespace softcnc::app
