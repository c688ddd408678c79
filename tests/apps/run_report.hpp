// SPDX-License-Identifier: MIT
// The report of a run, without what depends on the computer.
#pragma once

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <string>

#include "apps/shell.hpp"

namespace softcnc::app::test {

inline nlohmann::json report_of(const std::string& arguments, int status = 0) {
  const Folder folder;
  const Ended ended = call("run -q " + arguments + " --report " + (folder / "r.json"));
  CAPTURE(ended.err);
  CHECK(ended.status == status);
  return nlohmann::json::parse(read(folder / "r.json"));
}

}  // namespace softcnc::app::test
