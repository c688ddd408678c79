// SPDX-License-Identifier: MIT
// A file without a name: it is gone when its process is, however that ends.
#pragma once

namespace softcnc {

/// A descriptor of a new empty file in the folder for temporary files, for reading and writing; the
/// caller closes it. Below 0: errno says why there is none.
int open_unnamed_file();

}  // namespace softcnc
