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

/// Words for a person go to stderr as they are.
void set_up_words(const Options& options) {
  spdlog::set_default_logger(spdlog::stderr_logger_st("softcnc"));
  spdlog::set_pattern("%v");
  if (options.quiet) spdlog::set_level(spdlog::level::warn);
  if (options.verbose) spdlog::set_level(spdlog::level::debug);
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
    case Command::machine:
      return machine(options);
  }
  return 0;
}

int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);  // a closed pipe is an error of the write that meets it
  const auto parsed = parse_command_line(argc, argv);
  if (const int* status = std::get_if<int>(&parsed)) return *status;
  const auto& options = std::get<Options>(parsed);
  set_up_words(options);
  return dispatch(options);
}

}  // namespace
}  // namespace softcnc::app

int main(int argc, char** argv) {
  using softcnc::Code;
  try {
    return softcnc::app::main(argc, argv);
  } catch (const std::exception& error) {
    return softcnc::app::failed({Code::SC9001, {}, error.what(), {}, {}});
  }
}
