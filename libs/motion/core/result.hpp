// SPDX-License-Identifier: MIT
// The result of a function that makes one thing or reports why it cannot.
#pragma once

#include <tl/expected.hpp>

#include "motion/core/diagnostic.hpp"

namespace softcnc {

template <typename T>
using Result = tl::expected<T, Diagnostic>;

using Status = Result<void>;

}  // namespace softcnc
