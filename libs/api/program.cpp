// SPDX-License-Identifier: MIT
#include <istream>
#include <iterator>
#include <softcnc/program.hpp>
#include <utility>

#include "api/convert.hpp"
#include "api/data.hpp"
#include "runtime/check/check.hpp"
#include "runtime/program/source_line.hpp"
#include "runtime/run/repeated_errors.hpp"

namespace softcnc::api {

Program::Program(std::unique_ptr<Data> data) noexcept : data_(std::move(data)) {}
Program::Program(Program&& other) noexcept = default;
Program& Program::operator=(Program&& other) noexcept = default;
Program::~Program() = default;

Expected<Program> Program::open(const std::string& file) {
  auto program = runtime::Program::open(file);
  if (!program) return error_of(program.error());
  return Program(std::make_unique<Data>(Data{std::move(*program)}));
}

Expected<Program> Program::from_text(const std::string& text, const std::string& name) {
  auto file = runtime::unlinked_file();
  if (!file) return error_of(file.error());
  if (const Status written = runtime::write_all(*file, text); !written)
    return error_of(written.error());
  return Program(std::make_unique<Data>(Data{runtime::Program::in_file(name, std::move(*file))}));
}

Expected<Program> Program::from_stream(std::istream& in, const std::string& name) {
  return from_text({std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()}, name);
}

const std::string& Program::name() const noexcept { return data_->program.name(); }

std::vector<Diagnostic> check(const Program& program, const Machine& machine,
                              const RunOptions& options) {
  return check(program, machine, options, {});
}

std::vector<Diagnostic> check(const Program& program, const Machine& machine,
                              const RunOptions& options, std::stop_token stop) {
  runtime::Program& text = program.data().program;
  const RunSetup setup(options, &text);
  runtime::ChannelOptions channel = setup.channel();
  channel.interpreter.compare_dialects = true;
  channel.interpreter.unreachable_too = true;
  channel.interpreter.stop = stop;
  StopRequests watcher(std::move(stop));
  std::vector<Diagnostic> all;
  runtime::ShownOnce shown(text, channel.interpreter, [&](softcnc::Diagnostic diagnostic) {
    diagnostic.source_line = runtime::source_line(diagnostic, text);
    all.push_back(diagnostic_of(diagnostic));
  });
  Diagnostics diagnostics(shown.sink());
  diagnostics.set_file(text.name());
  runtime::check(text, machine.data().machine, channel, diagnostics, &watcher,
                 runtime::CheckNotes::surface_too);
  shown.finish();
  return all;
}

}  // namespace softcnc::api
