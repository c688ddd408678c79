// SPDX-License-Identifier: MIT
// Errors of a program that wait until it is known which of them follow from others.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "ipr/interpreter/repairs.hpp"
#include "job/endless_rounds.hpp"
#include "messages/messages.hpp"
#include "messages/repeated_errors.hpp"
#include "program/program.hpp"
#include "session/channel_options.hpp"
#include "session/watcher.hpp"

namespace softcnc::app {

/// Shows what is told of a program as it comes up to its first error; that and what is told behind
/// it wait for finish(), which leaves out errors that follow from others. Of a stream and where
/// there are very many, all are shown at once; of a long text none is left out. Of errors with one
/// cause the first counts, and a note says on how many lines it stands.
class HeldErrors {
 public:
  /// What is referred to must outlive it.
  HeldErrors(Program& program, const Machine& machine, const ChannelOptions& options,
             Messages& messages, Watcher* watcher);

  Diagnostics::Sink sink();
  void finish();
  /// The worst exit status of what has been shown.
  int status() const noexcept { return status_; }

 private:
  void show(const Diagnostic& diagnostic);
  void take(const Diagnostic& diagnostic);
  void show_all();
  void leave_out();
  void leave_out(const std::vector<bool>& follows);
  Rounds read_rounds(const std::string& text, int block_limit) const;
  ipr::Verdict judge(const std::string& text) const;
  std::int64_t read(const std::string& text, int block_limit, ipr::InterpreterOptions reading,
                    Diagnostics::Sink told) const;

  Program& program_;
  const Machine& machine_;
  const ChannelOptions& options_;
  Watcher* watcher_;
  Diagnostics::Sink show_;
  RepeatedErrors repeated_;
  bool holding_;
  int status_ = 0;
  std::vector<Diagnostic> held_;
};

}  // namespace softcnc::app
