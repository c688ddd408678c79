// SPDX-License-Identifier: MIT
// Programs that are checked, read and run.
#include <algorithm>

#include "arrays.hpp"
#include "bindings.hpp"
#include "hal/backends/backend.hpp"
#include "ipr/interpreter/interpreter.hpp"
#include "options.hpp"
#include "output/block_json.hpp"
#include "runtime/check/check.hpp"
#include "runtime/program/each_block.hpp"
#include "runtime/program/source_line.hpp"
#include "runtime/run/repeated_errors.hpp"
#include "runtime/run/run.hpp"
#include "runtime/sinks/contour_rows.hpp"
#include "runtime/sinks/trace_rows.hpp"

namespace softcnc::python {
namespace {

/// A program: the name of a file, or a text.
struct Part {
  std::string file, text;
  bool is_text = false;

  api::Program open() const {
    return value_of(is_text ? api::Program::from_text(text, file) : api::Program::open(file));
  }
};

/// What is wrong with a program, with the lines that it quotes.
class Found {
 public:
  explicit Found(runtime::Program& program) : program_(program) {}

  Diagnostics::Sink sink() {
    return [this](softcnc::Diagnostic diagnostic) {
      diagnostic.source_line = runtime::source_line(diagnostic, program_);
      all_.push_back(api::diagnostic_of(diagnostic));
    };
  }
  const std::vector<api::Diagnostic>& all() const noexcept { return all_; }
  void raise_errors() const {
    if (std::any_of(all_.begin(), all_.end(),
                    [](const auto& one) { return one.severity == api::Severity::error; }))
      raise(all_);
  }

 private:
  runtime::Program& program_;
  std::vector<api::Diagnostic> all_;
};

/// What a run needs that must outlive it.
class Setup {
 public:
  Setup(const api::Program& program, const Options& options, Interruption& interruption)
      : options_(run_options(options, interruption)), setup_(options_, &program.data().program) {
    channel = setup_.channel();
    channel.interpreter.stop = interruption.stop();
  }
  runtime::ChannelOptions channel;

 private:
  api::RunOptions options_;
  api::RunSetup setup_;
};

std::vector<runtime::CurveColumn> curve_columns(const std::optional<Names>& asked) {
  std::vector<runtime::CurveColumn> columns;
  if (!asked) return columns;
  for (const runtime::CurveColumn column : runtime::all_curve_columns())
    if (std::find(asked->begin(), asked->end(), runtime::name(column)) != asked->end())
      columns.push_back(column);
  return columns;
}

py::dict run(const Part& part, const api::Machine& machine, const Options& options,
             const std::optional<Names>& asked, bool simulated) {
  const api::Program program = part.open();
  runtime::Program& text = program.data().program;
  Machine model =
      simulated ? machine.data().machine : runtime::without_backend(machine.data().machine);
  if (simulated) model.control.backend = BackendKind::sim;
  const auto backend = hal::open_backend(model);
  if (!backend) raise(api::error_of(backend.error()));
  const auto curves = curve_columns(asked);
  Names further = runtime::row_columns(**backend);
  for (const runtime::CurveColumn column : curves) further.emplace_back(runtime::name(column));
  auto arrays = std::make_unique<ArrayTrace>(model, further, asked);
  ArrayTrace& trace = *arrays;
  runtime::TraceRows rows(std::move(arrays), curves);
  Found found(text);
  runtime::JudgedRun judged;
  interruptible([&](Interruption& interruption) {
    const Setup setup(program, options, interruption);
    api::StopRequests watcher(interruption.stop());
    judged = runtime::run({text, model, setup.channel, **backend, &rows, &watcher}, found.sink());
  });
  if (!trace.ok()) throw std::bad_alloc();
  if (judged.ending == runtime::Ending::error) found.raise_errors();
  py::dict result;
  result["columns"] = trace.take();
  result["time_s"] = judged.outcome.time;
  result["length_mm"] = judged.outcome.last.s;
  result["diagnostics"] = found.all();
  return result;
}

std::vector<api::Diagnostic> check(const Part& part, const api::Machine& machine,
                                   const Options& options) {
  const api::Program program = part.open();
  std::vector<api::Diagnostic> all;
  interruptible([&](Interruption& interruption) {
    all = api::check(program, machine, run_options(options, interruption), interruption.stop());
  });
  return all;
}

Names blocks(const Part& part, const api::Machine& machine, const Options& options) {
  const api::Program program = part.open();
  runtime::Program& text = program.data().program;
  const Machine& model = machine.data().machine;
  Found found(text);
  Names lines;
  interruptible([&](Interruption& interruption) {
    const Setup setup(program, options, interruption);
    runtime::ShownOnce shown(text, setup.channel.interpreter, found.sink());
    Diagnostics diagnostics(shown.sink());
    diagnostics.set_file(text.name());
    ipr::Reader reader = text.reader();
    ipr::Parser parser(reader, diagnostics);
    ipr::Interpreter interpreter(parser, model, diagnostics, setup.channel.interpreter,
                                 setup.channel.state);
    app::BlockJson json(&model.outputs);
    const std::stop_token stop = interruption.stop();
    const auto take = [&](const Block& block) {
      lines.emplace_back(json(block, diagnostics.file(block.source.file)));
      return !stop.stop_requested();
    };
    runtime::each_block(interpreter, take, [] { return false; });
    shown.finish();
  });
  found.raise_errors();
  return lines;
}

}  // namespace

void add_runs(py::module_& module) {
  add_options(module);
  py::class_<Part>(module, "Part")
      .def(py::init([](const std::string& file) {
        return Part{file, {}, false};
      }))
      .def_static("of_text", [](const std::string& text, const std::string& name) {
        return Part{name, text, true};
      });
  module.def("run", run);
  module.def("check", check);
  module.def("blocks", blocks);
  py::list names;
  for (const std::string_view name : runtime::kCurveColumnNames) names.append(name);
  module.attr("CURVE_COLUMNS") = py::tuple(names);
}

}  // namespace softcnc::python
