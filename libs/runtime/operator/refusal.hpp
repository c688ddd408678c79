// SPDX-License-Identifier: MIT
// The answer to a request that is not possible in the present state.
#pragma once

#include <string>
#include <utility>

#include "motion/core/result.hpp"

namespace softcnc::runtime {

inline tl::unexpected<Diagnostic> refusal(std::string why) {
  return tl::make_unexpected(Diagnostic{.code = Code::SC5080, .message = std::move(why)});
}

}  // namespace softcnc::runtime
