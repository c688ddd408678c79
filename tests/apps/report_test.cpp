// SPDX-License-Identifier: MIT
// The page of a run: its data against the trace and the figures of the same run.
#include <zlib.h>

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "apps/shell.hpp"

namespace softcnc::app::test {
namespace {

using Catch::Matchers::WithinAbs;
using nlohmann::json;

std::string unbase64(const std::string& text) {
  std::array<int, 256> digits{};
  const std::string alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (std::size_t i = 0; i < alphabet.size(); ++i)
    digits[static_cast<unsigned char>(alphabet[i])] = static_cast<int>(i);
  std::string bytes;
  unsigned group = 0;
  int bits = 0;
  for (const char letter : text) {
    if (letter == '=') break;
    group = group << 6U | static_cast<unsigned>(digits[static_cast<unsigned char>(letter)]);
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes.push_back(static_cast<char>(group >> bits & 255U));
  }
  return bytes;
}

std::string gunzip(const std::string& bytes) {
  z_stream stream{};
  REQUIRE(::inflateInit2(&stream, 15 + 16) == Z_OK);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  std::string out, piece(1 << 16, '\0');
  int state = Z_OK;
  while (state == Z_OK) {
    stream.next_out = reinterpret_cast<Bytef*>(piece.data());
    stream.avail_out = static_cast<uInt>(piece.size());
    state = ::inflate(&stream, Z_NO_FLUSH);
    out.append(piece, 0, piece.size() - stream.avail_out);
  }
  ::inflateEnd(&stream);
  REQUIRE(state == Z_STREAM_END);
  return out;
}

/// What stands in a script element.
std::string element(const std::string& page, const std::string& id) {
  const std::size_t at = page.find("id=\"" + id + "\">");
  REQUIRE(at != std::string::npos);
  const std::size_t begin = page.find('>', at) + 1;
  return page.substr(begin, page.find("</script>", begin) - begin);
}

struct Page {
  explicit Page(const std::string& file)
      : html(read(file)),
        data(json::parse(element(html, "softcnc-report"))),
        bytes(gunzip(unbase64(element(html, "softcnc-data")))) {}

  /// The numbers of a column.
  std::vector<double> column(const json& column) const {
    std::vector<double> values;
    std::size_t at = column["offset"];
    const std::size_t end = at + std::size_t(column["bytes"]);
    std::int64_t last = 0, difference = 0;
    while (at < end) {
      std::uint64_t number = 0;
      unsigned shift = 0, byte = 0;
      do {
        byte = static_cast<unsigned char>(bytes[at++]);
        number |= std::uint64_t(byte & 127U) << shift;
        shift += 7;
      } while (byte & 128U);
      auto value =
          static_cast<std::int64_t>(number >> 1U) ^ -static_cast<std::int64_t>(number & 1U);
      if (column["order"] == 2) value += difference;
      if (column["order"] != 0) value += last;
      difference = value - last;
      last = value;
      values.push_back(static_cast<double>(value) * double(column["scale"]));
    }
    REQUIRE(values.size() == std::size_t(column["count"]));
    return values;
  }
  std::vector<double> node(const std::string& name, int run = 0) const {
    return column(data["runs"][static_cast<std::size_t>(run)]["nodes"][name]);
  }

  std::string html;
  json data;
  std::string bytes;
};

Page page_of(const std::string& arguments, int status = 0) {
  const Folder folder;
  const Ended ended = call("report " + arguments + " -o " + (folder / "r.html"));
  INFO(ended.err);
  CHECK(ended.status == status);
  return Page(folder / "r.html");
}

std::pair<double, double> range(const std::vector<double>& values) {
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return {*least, *most};
}

struct CsvRow {
  std::map<std::string, std::string> values;
  double number(const std::string& name) const { return std::stod(values.at(name)); }
};

std::vector<CsvRow> csv_rows(const std::string& arguments) {
  const Ended ended = call("run --dry-run -q " + arguments);
  REQUIRE(ended.status == 0);
  std::istringstream text(ended.out);
  std::string line;
  std::vector<std::string> names;
  std::vector<CsvRow> rows;
  while (std::getline(text, line)) {
    if (line.starts_with('#')) continue;
    std::istringstream fields(line);
    std::string field;
    CsvRow row;
    for (std::size_t i = 0; std::getline(fields, field, ','); ++i) {
      if (rows.empty() && names.size() == i && !std::isdigit(field[0])) {
        names.push_back(field);
        continue;
      }
      row.values[names[i]] = field;
    }
    if (!row.values.empty()) rows.push_back(row);
  }
  return rows;
}

}  // namespace

TEST_CASE("the page of a run has the motion of its trace within the error that it states",
          "[apps][report]") {
  for (const std::string program :
       {"$programs/08_butterfly.nc", "$programs/03_arc.nc", "$programs/15_splines.nc"}) {
    INFO(program);
    const Page page = page_of(program + " --backend none");
    const json& run = page.data["runs"][0];
    const auto rows = csv_rows(program + " --backend none");
    CHECK(run["setpoints"] == rows.size());
    const auto row = page.node("row"), v = page.node("v");
    const auto spans = page.column(run["spans"]["row"]), lines = page.column(run["spans"]["line"]);
    const double mm = 1e-3 * double(run["error_um"]) + 1e-9;
    const double mm_s = double(run["error_mm_s"]) + 1e-9;
    for (const std::string axis : {"x", "y", "z"}) {
      const auto at = page.node(axis);
      std::size_t i = 0;
      for (std::size_t k = 0; k < rows.size(); ++k) {
        while (row[i] < static_cast<double>(k)) ++i;
        const double part =
            i == 0 ? 1 : (static_cast<double>(k) - row[i - 1]) / (row[i] - row[i - 1]);
        const double x = i == 0 ? at[0] : at[i - 1] + part * (at[i] - at[i - 1]);
        const double speed = i == 0 ? v[0] : v[i - 1] + part * (v[i] - v[i - 1]);
        CHECK_THAT(x, WithinAbs(rows[k].number(axis + "_mm"), mm));
        CHECK_THAT(speed, WithinAbs(rows[k].number("v_mm_s"), mm_s));
      }
    }
    std::size_t span = 0;
    for (std::size_t k = 1; k < rows.size(); ++k) {
      while (span + 1 < spans.size() && spans[span + 1] < static_cast<double>(k)) ++span;
      CHECK(lines[span] == rows[k].number("line"));
    }
  }
}

TEST_CASE("the page of a run has its figures", "[apps][report]") {
  const Page page = page_of("$programs/08_butterfly.nc");
  const Folder folder;
  REQUIRE(call("run -q $programs/08_butterfly.nc --report " + (folder / "r.json")).status == 0);
  const json report = json::parse(read(folder / "r.json"));
  const json& run = page.data["runs"][0];
  CHECK(run["time_s"] == report["time_s"]);
  CHECK(run["length_mm"] == report["length_mm"]);
  for (const json& part : run["time_by_limit_s"])
    CHECK(part["seconds"] == report["time_by_limit_s"][std::string(part["limit"])]);
  REQUIRE(run["worst_lines"].size() > 0);
  for (std::size_t i = 0; i < run["worst_lines"].size(); ++i) {
    CHECK(run["worst_lines"][i]["line"] == report["worst_lines"][i]["line"]);
    CHECK(run["worst_lines"][i]["limit"] == report["worst_lines"][i]["limit"]);
  }
  double contour = 0;
  for (const double um : page.node("contour_um")) contour = std::max(contour, um);
  CHECK_THAT(contour, WithinAbs(report["contour_error_um_max"], 0.01 * contour));
  const auto ms = page.column(run["lines"]["ms"]);
  double seconds = 0;
  for (const double one : ms) seconds += one / 1000;
  CHECK_THAT(seconds, WithinAbs(report["time_s"], 1e-4 * static_cast<double>(ms.size())));
  const json& text = run["files"][0]["text"];
  CHECK(page.bytes.substr(text["offset"], text["bytes"]) ==
        read(SOFTCNC_SOURCE_DIR "/programs/08_butterfly.nc"));
}

TEST_CASE("the same run gives the same page", "[apps][report]") {
  CHECK(page_of("$programs/15_splines.nc --what-if").html ==
        page_of("$programs/15_splines.nc --what-if").html);
}

TEST_CASE("a program with errors has a page that shows them", "[apps][report]") {
  const Folder folder;
  write(folder / "p.nc", "G21 G90\nG1 X10 F600\nG1 X2O\nG1 X30 Q\nM2\n");
  const Page page = page_of(folder / "p.nc", 1);
  const json& run = page.data["runs"][0];
  CHECK(run["status"] == "error");
  REQUIRE(run["diagnostics"].size() == 2);
  CHECK(run["diagnostics"][0]["line"] == 3);
  CHECK(run["diagnostics"][0]["severity"] == "error");
  CHECK(run["diagnostics"][1]["line"] == 4);
  CHECK(std::string(run["diagnostics"][1]["code"]).starts_with("SC"));
  CHECK(page.bytes.find("G1 X2O") != std::string::npos);
}

TEST_CASE("no text of a program ends the elements of its page", "[apps][report]") {
  const Folder folder;
  write(folder / "p.nc", "(</script><script>alert(1)</script>)\nG21 G90\nG1 X1 F600\n</b>\nM2\n");
  const Page page = page_of(folder / "p.nc", 1);
  CHECK(element(page.html, "softcnc-report").find('<') == std::string::npos);
}

TEST_CASE("a page of a trace or a recording shows the rows that were written", "[apps][report]") {
  const Folder folder;
  const std::string part = "$programs/15_splines.nc ";
  REQUIRE(call("run -q " + part + "--trace " + (folder / "t.csv")).status == 0);
  REQUIRE(call("run -q " + part + "--trace " + (folder / "t.npz")).status == 0);
  REQUIRE(call("record -q " + part + "-o " + (folder / "t.rec")).status == 0);
  const Page of_program = page_of(part);
  for (const std::string file : {"t.csv", "t.npz", "t.rec"}) {
    INFO(file);
    const Page page = page_of(folder / file);
    CHECK(page.data["runs"][0]["setpoints"] == of_program.data["runs"][0]["setpoints"]);
    CHECK(page.node("row").back() == of_program.node("row").back());
    for (const std::string column : {"x", "y", "z", "contour_um", "feed"}) {
      INFO(column);
      const auto [least, most] = range(page.node(column));
      const auto [least_there, most_there] = range(of_program.node(column));
      CHECK_THAT(least, WithinAbs(least_there, 0.002));
      CHECK_THAT(most, WithinAbs(most_there, 0.002));
    }
    CHECK(page.column(page.data["runs"][0]["spans"]["row"]) ==
          of_program.column(of_program.data["runs"][0]["spans"]["row"]));
    CHECK_THAT(page.data["runs"][0]["time_s"],
               WithinAbs(of_program.data["runs"][0]["time_s"], 0.002));
  }
  const json& lines = of_program.data["runs"][0]["worst_lines"];
  for (const std::string file : {"t.csv", "t.rec"}) {
    const Page page = page_of(folder / file);
    REQUIRE(page.data["runs"][0]["worst_lines"].size() > 0);
    CHECK(page.data["runs"][0]["worst_lines"][0]["line"] == lines[0]["line"]);
    CHECK(page.data["runs"][0]["worst_lines"][0]["limit"] == lines[0]["limit"]);
  }
  const Page recorded = page_of(folder / "t.rec");
  CHECK(recorded.data["runs"][0]["files"][0].contains("text"));
  CHECK_THAT(range(recorded.node("acceleration_use")).second,
             WithinAbs(range(of_program.node("acceleration_use")).second, 0.011));
}

TEST_CASE("raised limits win what a run with them takes less", "[apps][report]") {
  const Page page = page_of("$programs/15_splines.nc --what-if");
  const json& what_if = page.data["what_if"];
  REQUIRE(what_if["rows"].size() >= 4);
  const auto time = [](const std::string& arguments) {
    const Folder folder;
    REQUIRE(
        call("run -q $programs/15_splines.nc --report " + (folder / "r.json") + arguments).status ==
        0);
    return double(json::parse(read(folder / "r.json"))["time_s"]);
  };
  CHECK_THAT(what_if["time_s"], WithinAbs(time(""), 1e-9));
  for (const json& row : what_if["rows"])
    if (row["axis"] == "x" && row["limit"] == "acceleration")
      CHECK_THAT(row["time_s"], WithinAbs(time(" --set axis.x.acceleration_mm_s2=1500"), 1e-9));
}

TEST_CASE("a page of two runs has the difference of their times", "[apps][report]") {
  const Page page =
      page_of("$programs/08_butterfly.nc --compare-set axis.x.acceleration_mm_s2=2000");
  REQUIRE(page.data["runs"].size() == 2);
  const json& comparison = page.data["comparison"];
  CHECK(comparison["time_s"][0] == page.data["runs"][0]["time_s"]);
  CHECK(comparison["time_s"][1] == page.data["runs"][1]["time_s"]);
  CHECK(comparison["names"][0] != comparison["names"][1]);
  double by_line = 0, by_limit = 0;
  for (const json& line : comparison["by_line"])
    by_line += double(line["b_s"]) - double(line["a_s"]);
  for (const json& limit : comparison["by_limit"])
    by_limit += double(limit["b_s"]) - double(limit["a_s"]);
  const double won = double(comparison["time_s"][1]) - double(comparison["time_s"][0]);
  CHECK(won < -0.01);
  CHECK_THAT(by_line, WithinAbs(won, 1e-5));
  CHECK_THAT(by_limit, WithinAbs(won, 1e-5));
}

TEST_CASE("options of pictures and pages are refused where they have no effect", "[apps][report]") {
  const Folder folder;
  const std::string part = "report $programs/03_arc.nc -o ";
  CHECK(call(part + (folder / "r.html") + " --plot feed").status == 2);
  CHECK(call(part + (folder / "r.html") + " --size 500").status == 2);
  CHECK(call(part + (folder / "r.svg") + " --what-if").status == 2);
  REQUIRE(call("run -q --dry-run $programs/03_arc.nc --trace " + (folder / "t.csv")).status == 0);
  const std::string rows = "report " + (folder / "t.csv") + " -o " + (folder / "r.html ");
  for (const std::string further : {"--what-if", "--compare builtin", "--set axis.x.blu_um=1",
                                    "--compare-set control.interpolation=dsm"}) {
    INFO(further);
    CHECK(call(rows + further).status == 2);
  }
  const Ended unknown = call(part + (folder / "r.pdf"));
  CHECK(unknown.status == 2);
  CHECK(shows(unknown.err, "SC6060"));
  CHECK(folder.files() == std::vector<std::string>{"t.csv"});
}

TEST_CASE("a page that cannot be written leaves nothing", "[apps][report]") {
  const Folder folder;
  const Ended missing = call("report $programs/03_arc.nc -o " + (folder / "no/r.html"));
  CHECK(missing.status == 5);
  const Ended full = call("report $programs/03_arc.nc -o /dev/full");
  CHECK(full.status == 5);
  const Ended absent = call("report " + (folder / "p.nc") + " -o " + (folder / "r.html"));
  CHECK(absent.status == 5);
  CHECK(folder.files().empty());
}

}  // namespace softcnc::app::test
