// SPDX-License-Identifier: MIT
// The table of trace formats, and how a file's name chooses from it.
#include "hal/trace/trace.hpp"

#include <sys/stat.h>

#include <string_view>

#include "hal/files/zstd_sink.hpp"
#include "hal/trace/trace_csv.hpp"
#include "hal/trace/trace_hal.hpp"
#include "hal/trace/trace_npz.hpp"
#include "hal/trace/trace_vcd.hpp"

namespace softcnc::hal {
namespace {

struct TraceFormat {
  std::string_view suffix;
  std::unique_ptr<TraceWriter> (*make)(std::unique_ptr<ByteSink>, const TraceHeader&,
                                       const Machine&, std::span<const std::string>);
};

constexpr TraceFormat kFormats[] = {
    {".csv", csv_trace},
    {".npz", npz_trace},
    {".vcd", vcd_trace},
    {".hal", hal_trace},
};
constexpr std::string_view kCompressed = ".zst";

bool no_regular_file(const std::string& file) {
  struct stat info {};
  return file == "-" || (::stat(file.c_str(), &info) == 0 && !S_ISREG(info.st_mode));
}

const TraceFormat* trace_format_of(std::string_view file) {
  for (const TraceFormat& format : kFormats)
    if (file.ends_with(format.suffix)) return &format;
  return nullptr;
}

}  // namespace

Result<std::unique_ptr<TraceWriter>> TraceWriter::open(const std::string& file,
                                                       const TraceHeader& header,
                                                       const Machine& machine,
                                                       std::span<const std::string> backend_columns,
                                                       Patience patience) {
  std::string_view name = file;
  const bool compressed = name.ends_with(kCompressed);
  if (compressed) name.remove_suffix(kCompressed.size());
  const TraceFormat* format = trace_format_of(name);
  if (!format && no_regular_file(file)) format = &kFormats[0];
  if (!format)
    return tl::make_unexpected(
        Diagnostic{.code = Code::SC6014,
                   .message = "no trace format has this suffix; known are " + trace_suffixes(),
                   .file = file});
  auto opened = OutputFile::open(file, std::move(patience));
  if (!opened) return tl::make_unexpected(std::move(opened.error()));
  std::unique_ptr<ByteSink> sink = std::move(*opened);
  if (compressed) sink = zstd_sink(std::move(sink));
  return format->make(std::move(sink), header, machine, backend_columns);
}

std::string trace_suffixes() {
  std::string text;
  for (const TraceFormat& format : kFormats)
    text += (text.empty() ? "" : ", ") + std::string(format.suffix);
  return text + ", each with or without a further " + std::string(kCompressed);
}

}  // namespace softcnc::hal
