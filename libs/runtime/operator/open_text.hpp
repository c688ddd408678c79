// SPDX-License-Identifier: MIT
// Lines of MDI that belong together: a loop, a branch or a subprogram runs once its last line has
// come.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace softcnc::runtime {

/// Collects lines until all that they open is closed again.
class OpenText {
 public:
  /// Adds a line. Returns all lines so far where nothing is open; an empty text where more must
  /// come.
  std::string add(std::string_view line);
  bool is_open() const noexcept { return !open_.empty(); }
  void forget();

 private:
  struct Opened {
    std::string label;
    bool is_do = false;  // `while` of the same label closes it
  };
  void take(std::string_view line);
  void close(const std::string& label);

  std::string text_;
  std::vector<Opened> open_;
};

}  // namespace softcnc::runtime
