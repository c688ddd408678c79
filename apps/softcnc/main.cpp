// SPDX-License-Identifier: MIT
// Where it starts: the command line chooses a command.
#include <spdlog/sinks/base_sink.h>
#include <spdlog/spdlog.h>
#include <sys/resource.h>

#include <csignal>
#include <exception>
#include <memory>
#include <variant>

#include "commands/command_line.hpp"
#include "commands/commands.hpp"
#include "messages/messages.hpp"
#include "process/out_of_memory.hpp"
#include "process/signal_cleanup.hpp"
#include "process/standard_error.hpp"

namespace softcnc::app {
namespace {

/// Returns whether standard error is one document, without other text.
bool owns_stderr(const Options& options) {
  return options.diagnostics != DiagnosticsFormat::text && options.command != CommandName::check;
}

/// Log messages for a person, written to standard error as they are.
class StderrSink final : public spdlog::sinks::base_sink<spdlog::details::null_mutex> {
 protected:
  void sink_it_(const spdlog::details::log_msg& message) override {
    spdlog::memory_buf_t text;
    formatter_->format(message, text);
    write_to_stderr({text.data(), text.size()});
  }
  void flush_() override {}
};

void set_up_logging(const Options& options) {
  spdlog::set_default_logger(
      std::make_shared<spdlog::logger>("softcnc", std::make_shared<StderrSink>()));
  spdlog::set_pattern("%v");
  if (options.quiet) spdlog::set_level(spdlog::level::warn);
  if (options.verbose) spdlog::set_level(spdlog::level::debug);
  if (owns_stderr(options)) spdlog::set_level(spdlog::level::off);
}

/// Reports an unexpected exception: memory or threads have run out, or there is a defect.
int report_exception(const std::exception& error) {
  if (const std::string lacking = lacking_resource(error); !lacking.empty())
    return failed({.code = Code::SC6004, .message = lacking});
  return failed({.code = Code::SC9001, .message = error.what()});
}

/// Failures are reported by the call that fails, not by a signal; and files that are being written
/// are removed however softcnc ends.
void set_up_signals() {
  std::signal(SIGPIPE, SIG_IGN);  // a closed pipe
  std::signal(SIGXFSZ, SIG_IGN);  // a file that grows beyond the limit of its size
  clean_up_files_on_signal();
  handle_out_of_memory();
}

/// Each file that a program calls is kept open: the usual 1024 may be too few for large programs.
void allow_many_files() noexcept {
  rlimit limit{};
  if (::getrlimit(RLIMIT_NOFILE, &limit) != 0) return;
  limit.rlim_cur = limit.rlim_max;
  ::setrlimit(RLIMIT_NOFILE, &limit);
}

int dispatch(const Options& options) {
  switch (options.command) {
    case CommandName::run:
      return run(options);
    case CommandName::check:
      return check(options);
    case CommandName::blocks:
      return blocks(options);
    case CommandName::convert:
      return convert(options);
    case CommandName::operate:
      return operate(options);
    case CommandName::serve:
      return serve(options);
    case CommandName::record:
      return record(options);
    case CommandName::replay:
      return replay(options);
    case CommandName::report:
      return report(options);
    case CommandName::circle:
      return circle(options);
    case CommandName::diff:
      return diff(options);
    case CommandName::surface:
      return surface(options);
    case CommandName::compare:
      return compare(options);
    case CommandName::identify:
      return identify(options);
    case CommandName::machine:
      return machine(options);
    case CommandName::state:
      return state(options);
    case CommandName::latency:
      return latency(options);
    case CommandName::pulses:
      return pulses(options);
    case CommandName::codes:
      return codes(options);
  }
  return 0;
}

int main(int argc, char** argv) {
  occupy_standard_descriptors();
  set_up_signals();
  allow_many_files();
  const auto parsed = parse_command_line(argc, argv);
  if (const int* status = std::get_if<int>(&parsed)) return *status;
  const auto& options = std::get<Options>(parsed);
  set_up_logging(options);
  if (owns_stderr(options)) begin_document(options.diagnostics);
  int status = 0;
  try {
    status = dispatch(options);
  } catch (const std::exception& error) {
    status = report_exception(error);
  }
  return end_document(status);
}

}  // namespace
}  // namespace softcnc::app

int main(int argc, char** argv) {
  try {
    return softcnc::app::main(argc, argv);
  } catch (const std::exception& error) {  // of the command line
    return softcnc::app::report_exception(error);
  }
}
