// SPDX-License-Identifier: MIT
// What the shared library shows to its users.
#pragma once

#define SOFTCNC_API __attribute__((visibility("default")))
