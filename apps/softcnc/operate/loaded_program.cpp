// SPDX-License-Identifier: MIT
#include "operate/loaded_program.hpp"

#include <utility>

#include "input/program_run.hpp"
#include "job/preflight.hpp"
#include "runtime/check/endless.hpp"

namespace softcnc::app {
namespace {

class StopWatch final : public runtime::Watcher {
 public:
  explicit StopWatch(const std::function<bool()>& is_stopped) : is_stopped_(is_stopped) {}
  bool wants_stop() override { return stopped_ = stopped_ || (is_stopped_ && is_stopped_()); }
  void sees(const Setpoint&) override {}
  void pause(const runtime::Pause&) override {}
  void wait_for_input(int) override {}

 private:
  const std::function<bool()>& is_stopped_;
  bool stopped_ = false;
};

}  // namespace

LoadedProgram::LoadedProgram(runtime::Program program, std::string text)
    : program_(std::move(program)), text_(std::move(text)) {
  for (std::size_t begin = 0; begin < text_.size(); begin = text_.find('\n', begin) + 1) {
    begins_.push_back(begin);
    if (text_.find('\n', begin) == std::string::npos) break;
  }
}

Result<LoadedProgram> LoadedProgram::open(const std::string& file) {
  std::error_code error;
  const bool is_fit =
      std::filesystem::is_regular_file(file, error) && std::filesystem::file_size(file) <= kLargest;
  if (!is_fit && std::filesystem::exists(file, error))
    return tl::make_unexpected(
        Diagnostic{.code = Code::SC6001, .message = "not a file of at most 256 MiB", .file = file});
  auto program = runtime::Program::open(file);
  if (!program) return tl::make_unexpected(std::move(program.error()));
  std::string text = program_text(*program);
  if (Status read = program->read_status(); !read) return tl::make_unexpected(read.error());
  LoadedProgram loaded(std::move(*program), std::move(text));
  loaded.written_ = std::filesystem::last_write_time(file, error);
  return loaded;
}

bool LoadedProgram::has_changed() const {
  std::error_code error;
  const auto written = std::filesystem::last_write_time(name(), error);
  return !error && written != written_;
}

std::string_view LoadedProgram::line(int number) const noexcept {
  if (number < 1 || number > lines()) return {};
  const std::size_t begin = begins_[static_cast<std::size_t>(number - 1)];
  std::string_view line = std::string_view(text_).substr(begin);
  line = line.substr(0, line.find('\n'));
  return line.ends_with('\r') ? line.substr(0, line.size() - 1) : line;
}

const CheckedProgram* LoadedProgram::checked(
    const runtime::ChannelOptions& options) const noexcept {
  const bool holds = checked_ && checked_->state == options.state &&
                     checked_->outputs == options.outputs &&
                     checked_->block_skip == options.interpreter.block_skip &&
                     checked_->optional_stop == options.interpreter.optional_stop;
  return holds ? &*checked_ : nullptr;
}

void LoadedProgram::check(const Machine& machine, runtime::ChannelOptions options,
                          const std::function<bool()>& is_stopped) {
  checked_.reset();
  options.interpreter.folder = folder();
  options.interpreter.called = &program_.called();
  CheckedProgram checked;
  checked.state = options.state;
  checked.outputs = options.outputs;
  checked.block_skip = options.interpreter.block_skip;
  checked.optional_stop = options.interpreter.optional_stop;
  Messages messages([&checked](std::string_view text) { checked.found += text; }, false);
  StopWatch watch(is_stopped);
  const Preflight found = preflight(program_, machine, options, messages, &watch);
  if (watch.wants_stop()) return;
  checked.passed = found.status == 0;
  checked.errors = messages.count(Severity::error);
  checked.warnings = messages.count(Severity::warning);
  checked.time = found.outcome.time;
  Diagnostics silent([](const Diagnostic&) {});
  ipr::Reader reader = program_.reader();
  checked.span = runtime::read_unplanned(reader, machine, options, silent, &watch).travel.all();
  checked_ = std::move(checked);
}

}  // namespace softcnc::app
