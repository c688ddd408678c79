// SPDX-License-Identifier: MIT
// `softcnc circle`: the circular test of ISO 230-4 on the circles of a run.
#include <spdlog/spdlog.h>

#include "circle/circle_test.hpp"
#include "commands/commands.hpp"
#include "hal/files/output_file.hpp"
#include "messages/messages.hpp"
#include "messages/standard_output.hpp"

namespace softcnc::app {
namespace {

Status write_picture(const CircleTest& test, const Options& options) {
  const auto format = picture_format(options.output);
  const auto named = [&](Diagnostic error) {
    if (error.file.empty()) error.file = options.output;
    return tl::make_unexpected(std::move(error));
  };
  if (!format)
    return named({.code = Code::SC6060,
                  .message = "no form of a picture has this suffix; known are .svg, .png"});
  const auto picture = circle_picture(test, options.picture, *format);
  if (!picture) return named(picture.error());
  if (Status written = hal::write_file(options.output, *picture); !written)
    return named(written.error());
  spdlog::info("picture written to {}", options.output);
  return {};
}

}  // namespace

int circle(const Options& options) {
  Messages messages([] {});
  const auto test = measure_circles(options);
  if (!test) return messages.fail(test.error());
  StandardOutput out;
  out.write(options.table == TableFormat::json ? circle_json(*test) : circle_text(*test));
  const int status = out.finish();
  if (options.output.empty()) return status;
  const Status written = write_picture(*test, options);
  return written ? status : worse_status(status, messages.fail(written.error()));
}

}  // namespace softcnc::app
