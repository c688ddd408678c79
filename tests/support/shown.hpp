// SPDX-License-Identifier: MIT
// What a text shows of diagnostics: "p.nc:3:1: error: X reaches ... [SC4001]", where "..." stands
// for whatever comes between on that line.
#pragma once

#include <string_view>

namespace softcnc {

/// Whether `text` begins with the form.
inline bool begins_showing(std::string_view text, std::string_view form) {
  constexpr std::string_view kAnything = "...";
  const std::size_t cut = form.find(kAnything);
  if (!text.starts_with(form.substr(0, cut))) return false;
  if (cut == std::string_view::npos) return true;
  const std::string_view rest = form.substr(cut + kAnything.size());
  const std::string_view line = text.substr(0, text.find('\n'));
  for (std::size_t at = cut; at <= line.size(); ++at)
    if (begins_showing(text.substr(at), rest)) return true;
  return false;
}

/// Where in `text` the form stands, from the byte `from` on; npos if it does not.
inline std::size_t where_shown(std::string_view text, std::string_view form, std::size_t from = 0) {
  for (; from < text.size(); ++from)
    if (begins_showing(text.substr(from), form)) return from;
  return std::string_view::npos;
}

/// Whether the form stands anywhere in `text`.
inline bool shows(std::string_view text, std::string_view form) {
  return where_shown(text, form) != std::string_view::npos;
}

}  // namespace softcnc
