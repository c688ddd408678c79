// SPDX-License-Identifier: MIT
// --diagnostics json|sarif: one whole document, and nothing beside it.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "apps/shell.hpp"
#include "messages/diagnostic_document.hpp"

using namespace softcnc;
using namespace softcnc::app;
using namespace softcnc::app::test;
using nlohmann::json;

namespace {

/// What the SARIF 2.1.0 schema requires of the objects used, and what must agree within them.
void check_sarif(const json& log) {
  CHECK(log.at("version") == "2.1.0");
  REQUIRE(log.at("runs").size() == 1);
  const json& run = log["runs"][0];
  CHECK(run.at("columnKind") == "unicodeCodePoints");
  const json& driver = run.at("tool").at("driver");
  CHECK(driver.at("name") == "softcnc");
  CHECK(driver.at("version") == SOFTCNC_VERSION);
  const json& rules = driver.at("rules");
  CHECK(rules.size() == code_table().size());
  for (const json& result : run.at("results")) {
    CHECK(!result.at("message").at("text").get<std::string>().empty());
    const json& rule = rules.at(result.at("ruleIndex").get<std::size_t>());
    CHECK(rule.at("id") == result.at("ruleId"));
    CHECK(rule.at("defaultConfiguration").at("level") == result.at("level"));
    CHECK(!rule.at("shortDescription").at("text").get<std::string>().empty());
    CHECK(!rule.at("help").at("text").get<std::string>().empty());
    for (const json& location : result.value("locations", json::array())) {
      const json& place = location.at("physicalLocation");
      CHECK(place.at("artifactLocation").at("uri").get<std::string>().find(' ') ==
            std::string::npos);
      if (!place.contains("region")) continue;
      CHECK(place["region"].at("startLine") >= 1);
      CHECK(place["region"].value("startColumn", 1) < place["region"].value("endColumn", 2));
    }
  }
  CHECK(run.at("invocations").at(0).at("executionSuccessful").is_boolean());
}

}  // namespace

TEST_CASE("check reports everything as one JSON array on stdout", "[apps][diagnostics]") {
  const Ended ended = shell(
      "cd $data; $softcnc check --diagnostics json two_errors.nc zigzag.nc beyond.nc none.nc");
  CHECK(ended.status == 5);
  CHECK(ended.err.empty());
  const json list = json::parse(ended.out);
  REQUIRE(list.size() == 5);
  CHECK(list[0] == json({{"file", "two_errors.nc"},
                         {"line", 3},
                         {"column", 6},
                         {"end_column", 11},
                         {"severity", "error"},
                         {"code", "SC1004"},
                         {"message", "two decimal points in '3.4.5'"},
                         {"help", "write one decimal point; put a letter before each number"},
                         {"source_line", "X20 Y3.4.5"}}));
  CHECK(list[2]["code"] == "SC4001");
  CHECK(list[4]["file"] == "none.nc");
  CHECK_FALSE(list[4].contains("line"));
}

TEST_CASE("a document says that nothing is wrong, too", "[apps][diagnostics]") {
  CHECK(call("check --diagnostics json $data/zigzag.nc").out == "[]\n");
  const Ended ended = call("check --diagnostics sarif $data/zigzag.nc");
  CHECK(ended.status == 0);
  const json log = json::parse(ended.out);
  check_sarif(log);
  CHECK(log["runs"][0]["results"].empty());
  CHECK(log["runs"][0]["invocations"][0] == json({{"executionSuccessful", true}, {"exitCode", 0}}));
}

TEST_CASE("columns count characters, and no bytes of a program break JSON", "[apps][diagnostics]") {
  const std::string part = "(\xc3\xa9t\xc3\xa9 \xff\x01) X1.2.3\nM30\n";
  const json list = json::parse(call("check --diagnostics json -", part).out);
  REQUIRE(list.size() == 2);
  CHECK(list[1]["code"] == "SC1059");  // coordinates before any motion code
  CHECK(list[0]["file"] == "<stdin>");
  CHECK(list[0]["column"] == 11);
  CHECK(list[0]["end_column"] == 16);
  CHECK(list[0]["source_line"] == "(\u00e9t\u00e9 \ufffd\ufffd) X1.2.3");
  const json log = json::parse(call("check --diagnostics sarif -", part).out);
  check_sarif(log);
  const json& place = log["runs"][0]["results"][0]["locations"][0]["physicalLocation"];
  CHECK(place["artifactLocation"]["uri"] == "%3Cstdin%3E");
  CHECK(place["region"] == json({{"startLine", 1}, {"startColumn", 11}, {"endColumn", 16}}));
}

TEST_CASE("SARIF names files by URI and results by rule", "[apps][diagnostics]") {
  const Folder folder;
  write(folder / "a b.nc", "G48\nM30\n");
  const Ended ended =
      shell("cd '" + (folder / "") +
            "'; $softcnc check --diagnostics sarif 'a b.nc' none.nc \"$PWD/a b.nc\"");
  CHECK(ended.status == 5);
  const json log = json::parse(ended.out);
  check_sarif(log);
  const json& results = log["runs"][0]["results"];
  REQUIRE(results.size() == 3);
  const auto uri = [&](std::size_t i) {
    return results[i]["locations"][0]["physicalLocation"]["artifactLocation"]["uri"]
        .get<std::string>();
  };
  CHECK(uri(0) == "a%20b.nc");
  CHECK(uri(1) == "none.nc");
  CHECK(uri(2).starts_with("file:///"));
  CHECK(uri(2).ends_with("/a%20b.nc"));
  CHECK(results[0]["ruleId"] == "SC2001");
  CHECK(log["runs"][0]["invocations"][0]["exitCode"] == 5);
  CHECK(log["runs"][0]["invocations"][0]["executionSuccessful"] == false);
}

TEST_CASE("file names become URI references", "[apps][diagnostics]") {
  CHECK(uri_of("parts/x-1_2.nc") == "parts/x-1_2.nc");
  CHECK(uri_of("/tmp/p.nc") == "file:///tmp/p.nc");
  CHECK(uri_of("a:b.nc") == "a%3Ab.nc");
  CHECK(uri_of("\xc3\xa4#?%.nc") == "%C3%A4%23%3F%25.nc");
}

TEST_CASE("other commands write the document to stderr, and no word beside it",
          "[apps][diagnostics]") {
  for (const char* command : {"run", "run --dry-run", "blocks", "record -o /dev/null"}) {
    CAPTURE(command);
    const std::string all = std::string(command) + " --diagnostics json ";
    const Ended bad = call(all + "$data/two_errors.nc");
    CHECK(bad.status == 1);
    CHECK(json::parse(bad.err).size() == 2);
    const Ended good = call(all + "$data/square.nc");
    CHECK(good.status == 0);
    CHECK(good.err == "[]\n");
    CHECK(json::parse(call(all + "none.nc").err)[0]["code"] == "SC6001");
    CHECK(json::parse(call(all + "$data/square.nc --machine none.toml").err)[0]["code"] ==
          "SC7003");
  }
  check_sarif(json::parse(call("run --diagnostics sarif $data/beyond.nc").err));
  CHECK(json::parse(call("machine --diagnostics json --set a=1").err)[0]["code"] == "SC7001");
  CHECK(json::parse(call("replay --diagnostics json none.rec").err).size() == 1);
  CHECK(call("run --diagnostics json --progress json $data/square.nc").err ==
        "--progress json and --diagnostics both use standard error\n"
        "Run with --help for more information.\n");
}

TEST_CASE("a document that cannot be written is an error, reported as text",
          "[apps][diagnostics]") {
  for (const char* form : {"json", "sarif"}) {
    const Ended ended =
        call(std::string("check --diagnostics ") + form + " $data/square.nc >/dev/full");
    CHECK(ended.status == 5);
    CHECK(ended.err == "<stdout>: error: writing failed: No space left on device [SC6012]\n");
  }
}
