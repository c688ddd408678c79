// SPDX-License-Identifier: MIT
// A file without a name: it disappears with its process, however that ends.
#pragma once

namespace softcnc {

/// Returns a descriptor of a new empty file in the folder for temporary files, for reading and
/// writing; the caller closes it. Below 0: errno is the reason.
int open_unnamed_file();

}  // namespace softcnc
