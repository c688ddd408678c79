// SPDX-License-Identifier: MIT
// Texts and keys as TOML spells them.
#pragma once

#include <string>
#include <string_view>

namespace softcnc::hal {

/// Returns a text as a TOML basic string, in quotes.
std::string toml_string(std::string_view text);

/// Returns whether TOML takes a key without quotes.
bool is_bare_key(std::string_view key) noexcept;

/// Returns a key: as it is where TOML takes it so, otherwise in quotes.
std::string toml_key(std::string_view key);

/// Returns a text as a part of a comment: without what ends a line or may not stand in TOML.
std::string comment_text(std::string_view text);

}  // namespace softcnc::hal
