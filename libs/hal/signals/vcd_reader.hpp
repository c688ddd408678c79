// SPDX-License-Identifier: MIT
// Value Change Dumps (IEEE 1364): the edges of the step and direction lines among their variables.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hal/signals/edge_format.hpp"
#include "hal/signals/edge_reader.hpp"

namespace softcnc::hal {

/// Variables of one bit that are called x_step, x_direction or x_dir and so on, in any scope, are
/// the lines; others are passed over. A line begins at its first level if that stands in
/// $dumpvars, otherwise low. Times finer than ns are rounded. A line longer than 1 MiB is refused
/// (SC6092): one is held in memory.
class VcdReader final : public EdgeParser {
 public:
  explicit VcdReader(VisitEdge visit) : visit_(std::move(visit)) {}

  Status read(std::string_view bytes) override;
  Status finish() override;

 private:
  using Token = std::string_view;

  void pass_blanks();
  std::string_view line() const;
  SourcePos place(Token token) const;
  Status failure(Token token, const std::string& why) const;
  Status too_long() const;

  Status take(Token token);
  Status take_keyword(Token token);
  Status take_part(Token token);
  Status end_definition(Token token);
  Status end_timescale(Token token);
  Status end_variable(Token token);
  Status take_time(Token token);
  Status take_level(Token token);
  Status take_vector(Token token);
  Status set(std::string_view variable, char value, Token token);
  void set(unsigned line, bool high, Token token);

  VisitEdge visit_;
  std::string text_;    // from the beginning of the current line
  std::size_t at_ = 0;  // in text_: not yet read
  std::size_t line_begin_ = 0;
  int line_number_ = 1;

  std::string within_;                  // the keyword whose words are being read; empty: none
  std::vector<std::string> words_;      // these
  bool defined_ = false;                // after $enddefinitions
  bool dumping_ = false;                // within $dumpvars and its kin
  std::string vector_;                  // a value that stands ahead of its variable; empty: none
  std::int64_t unit_ = 0, per_ns_ = 1;  // of time: ns, or a part of one; 0: not known yet
  std::map<std::string, unsigned, std::less<>> lines_;  // by the short name of the variable
  std::array<std::optional<bool>, kLineNumbers> level_{};
  std::int64_t time_ = 0;  // ns
};

}  // namespace softcnc::hal
