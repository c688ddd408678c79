// SPDX-License-Identifier: MIT
// Where it starts: the command line chooses a command.
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include <csignal>
#include <exception>
#include <variant>

#include "commands.hpp"
#include "messages.hpp"

namespace softcnc::app {
namespace {

/// Whether standard error is one document, with no words beside it.
bool owns_stderr(const Options& options) {
  return options.diagnostics != DiagnosticsFormat::text && options.command != Command::check;
}

/// Words for a person go to stderr as they are.
void set_up_words(const Options& options) {
  spdlog::set_default_logger(spdlog::stderr_logger_st("softcnc"));
  spdlog::set_pattern("%v");
  if (options.quiet) spdlog::set_level(spdlog::level::warn);
  if (options.verbose) spdlog::set_level(spdlog::level::debug);
  if (owns_stderr(options)) spdlog::set_level(spdlog::level::off);
}

int report_defect(const std::exception& error) {
  return failed({softcnc::Code::SC9001, {}, error.what(), {}, {}});
}

int dispatch(const Options& options) {
  switch (options.command) {
    case Command::run:
      return run(options);
    case Command::check:
      return check(options);
    case Command::blocks:
      return blocks(options);
    case Command::record:
      return record(options);
    case Command::replay:
      return replay(options);
    case Command::surface:
      return surface(options);
    case Command::machine:
      return machine(options);
    case Command::latency:
      return latency(options);
    case Command::pulses:
      return pulses(options);
    case Command::codes:
      return codes(options);
  }
  return 0;
}

int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);  // a closed pipe is an error of the write that meets it
  const auto parsed = parse_command_line(argc, argv);
  if (const int* status = std::get_if<int>(&parsed)) return *status;
  const auto& options = std::get<Options>(parsed);
  set_up_words(options);
  if (owns_stderr(options)) begin_document(options.diagnostics);
  int status = 0;
  try {
    status = dispatch(options);
  } catch (const std::exception& error) {
    status = report_defect(error);
  }
  end_document(status);
  return status;
}

}  // namespace
}  // namespace softcnc::app

int main(int argc, char** argv) {
  try {
    return softcnc::app::main(argc, argv);
  } catch (const std::exception& error) {  // of the command line
    return softcnc::app::report_defect(error);
  }
}
