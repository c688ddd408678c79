// SPDX-License-Identifier: MIT
// record and replay: the same run again, and the first row where it is not.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

#include "apps/recording_entries.hpp"
#include "apps/shell.hpp"
#include "hal/files/hash.hpp"
#include "hal/files/zip_file.hpp"
#include "recording/recording_meta.hpp"
#include "support/shown.hpp"
#include "support/zstd.hpp"

using namespace softcnc::app::test;
using nlohmann::json;
using softcnc::hal::Compression;
using softcnc::hal::ZipWriter;

namespace {

using softcnc::test::packed;
using softcnc::test::unpacked;

struct Content {
  std::string meta, program, machine, state, trace;
};

Content content(const std::string& file) {
  return {entry(file, "meta.json"), entry(file, "program"), entry(file, "machine.toml"),
          entry(file, "state.toml"), unpacked(entry(file, "trace.csv.zst"))};
}

void pack(const std::string& file, const Content& content) {
  ZipWriter zip(file);
  zip.add_text("meta.json", softcnc::app::sealed_meta(content.meta));
  zip.add_text("program", content.program);
  zip.add_text("machine.toml", content.machine);
  zip.add_text("state.toml", content.state);
  zip.add_text("trace.csv.zst", packed(content.trace));
  REQUIRE(zip.finish());
}

/// One value of a trace, replaced by what change() makes of it.
template <typename Change>
std::string changed(const std::string& trace, std::size_t row, std::size_t column,
                    Change&& change) {
  std::istringstream lines(trace);
  std::string text, line;
  for (std::size_t number = 0; std::getline(lines, line);) {
    const bool is_row = !line.starts_with('#') && !line.starts_with("t_s");
    if (is_row && ++number == row) {
      std::size_t begin = 0;
      for (std::size_t i = 0; i < column; ++i) begin = line.find(',', begin) + 1;
      const std::size_t end = std::min(line.find(',', begin), line.size());
      line.replace(begin, end - begin, change(line.substr(begin, end - begin)));
    }
    text += line + '\n';
  }
  return text;
}

std::string recorded(const Folder& folder, const std::string& part = "$data/square.nc") {
  const std::string file = folder / "run.rec";
  const Ended ended = call("record -q " + part + " -o " + file);
  CAPTURE(ended.err);
  REQUIRE(ended.status == 0);
  return file;
}

constexpr std::size_t kS = 3, kLimit = 6, kX = 7;

}  // namespace

TEST_CASE("a recording holds all that a replay needs, and agrees with it", "[apps][recording]") {
  const Folder folder;
  const std::string file = recorded(folder);
  const Content held = content(file);
  CHECK(held.program == read(data("square.nc")));
  CHECK(held.machine.find("[axis.x]") != std::string::npos);
  const json meta = json::parse(held.meta);
  CHECK(meta["schema"] == 2);
  CHECK(meta["softcnc"] == SOFTCNC_VERSION);
  CHECK(meta["program"]["hash"] == softcnc::hal::hash_hex(held.program));
  CHECK(meta["machine"]["hash"] == softcnc::hal::hash_hex(held.machine));
  CHECK(meta["trace"]["hash"] == softcnc::hal::hash_hex(entry(file, "trace.csv.zst")));
  const Trace trace = parse_trace(held.trace);
  CHECK(meta["trace"]["rows"] == trace.rows.size());
  CHECK(trace.columns[11] == "x_act_mm");

  const Ended ended = call("replay " + file);
  CHECK(ended.status == 0);
  CHECK(ended.out.empty());
  CHECK(ended.err == file + ": " + std::to_string(trace.rows.size()) + " rows agree\n");
}

TEST_CASE("two recordings of one run are the same bytes", "[apps][recording]") {
  const Folder one, two;
  CHECK(read(recorded(one)) == read(recorded(two)));
  CHECK(one.files() == std::vector<std::string>{"run.rec"});
}

TEST_CASE("options count in a replay as they did in the run", "[apps][recording]") {
  const Folder folder;
  write(folder / "p.nc", "G01 X10 F600\n/X20\nM30\n");
  const std::string file = recorded(folder, (folder / "p.nc") + " --block-skip --feed-override 30");
  CHECK(json::parse(content(file).meta)["options"]["feed_override"] == 0.3);
  CHECK(call("replay -q " + file).status == 0);
}

TEST_CASE("a program is replayed in the dialect it was recorded in", "[apps][recording]") {
  const Folder folder;
  write(folder / "p.nc", "G04 P250\nM30\n");
  const std::string file = recorded(folder, (folder / "p.nc") + " --dialect fanuc");
  Content held = content(file);
  json meta = json::parse(held.meta);
  CHECK(meta["options"]["dialect"] == "fanuc");
  CHECK(call("replay -q " + file).status == 0);

  meta["options"]["dialect"] = "linuxcnc";
  held.meta = meta.dump();
  pack(file, held);
  CHECK(call("replay -q " + file).status == 1);

  for (const char* dialect : {"haas", "auto"}) {
    CAPTURE(dialect);
    const std::string other =
        recorded(folder, (folder / "p.nc") + " --dialect " + std::string(dialect));
    CHECK(json::parse(content(other).meta)["options"]["dialect"] == dialect);
    CHECK(call("replay -q " + other).status == 0);
  }

  meta["options"]["dialect"] = "siemens";
  held.meta = meta.dump();
  pack(file, held);
  CHECK(call("replay -q " + file).err ==
        file + ": error: was made in a dialect this version does not know: 'siemens' [SC6022]\n");
}

TEST_CASE("a recording keeps the format that was asked for", "[apps][recording]") {
  const Folder folder;
  write(folder / "p.txt", "f 600\ns 1\n3 4\n");
  const std::string file = recorded(folder, (folder / "p.txt") + " --format commands");
  Content held = content(file);
  json meta = json::parse(held.meta);
  CHECK(meta["options"]["format"] == "commands");
  CHECK(call("replay -q " + file).status == 0);

  meta["options"]["format"] = "step";
  held.meta = meta.dump();
  pack(file, held);
  CHECK(call("replay -q " + file).err ==
        file + ": error: was made in a format this version does not know: 'step' [SC6022]\n");
}

TEST_CASE("one BLU in one row is a difference: the row is shown, exit status 1",
          "[apps][recording]") {
  const Folder folder;
  const std::string file = recorded(folder);
  Content held = content(file);
  const Trace trace = parse_trace(held.trace);
  held.trace = changed(held.trace, 321, kX,
                       [](const std::string& x) { return std::to_string(std::stod(x) + 0.0025); });
  pack(file, held);
  const Ended ended = call("replay " + file);
  CHECK(ended.status == 1);
  CHECK(ended.out.starts_with(file + ": row 321 differs\n"));  // its trace does not fit its hash
  CHECK(ended.out.find("\n! x_mm ") != std::string::npos);
  CHECK(ended.out.find("\n  y_mm ") != std::string::npos);
  CHECK(ended.out.find(trace.word(320, "x_mm") + "  -0.0025\n") != std::string::npos);
  CHECK(
      shows(ended.err,
            ".rec: error: row 321 "
            "differs: at 0.32 s, line ..., x_mm is ... in the recording "
            "and ... here; a different path, or a different part of it: the tool is 0.0025 mm away "
            "[SC6023]\n"));
}

TEST_CASE("a difference is a diagnostic for programs, too", "[apps][recording]") {
  const Folder folder;
  const std::string file = recorded(folder);
  const std::string slower = "replay " + file + " --set axis.x.acceleration_mm_s2=900";
  const Ended ended = call(slower + " --diagnostics json");
  CHECK(ended.status == 1);
  const json list = json::parse(ended.err);
  REQUIRE(list.size() == 1);
  CHECK(list[0]["file"] == file);
  CHECK(list[0]["severity"] == "error");
  CHECK(list[0]["code"] == "SC6023");
  const std::string message = list[0]["message"];
  CHECK(shows(message,
              "takes ... s instead of ... s (+... %), ... path; row 1 differs: at 0 s, line ..., "
              "a_mm_s2 is ... in the recording and ... "
              "here; the tool is in the same place"));
  const json sarif = json::parse(call(slower + " --diagnostics sarif").err);
  const json& result = sarif["runs"][0]["results"][0];
  CHECK(result["ruleId"] == "SC6023");
  CHECK(result["message"]["text"] == message);
  CHECK(sarif["runs"][0]["invocations"][0]["exitCode"] == 1);
}

TEST_CASE("lengths may differ by 1e-6 mm, names not at all", "[apps][recording]") {
  const Folder folder;
  const std::string file = recorded(folder);
  const Content held = content(file);
  const auto status_with = [&](std::size_t column, auto change) {
    Content other = held;
    other.trace = changed(held.trace, 200, column, change);
    json meta = json::parse(held.meta);
    meta["trace"]["hash"] = softcnc::hal::hash_hex(packed(other.trace));
    other.meta = meta.dump();
    pack(file, other);
    return call("replay -q " + file).status;
  };
  const auto add = [](double more) {
    return [more](const std::string& text) {
      std::ostringstream sum;
      sum.precision(17);
      sum << std::stod(text) + more;
      return sum.str();
    };
  };
  CHECK(status_with(kX, add(0.9e-6)) == 0);
  CHECK(status_with(kX, add(1.1e-6)) == 1);
  CHECK(status_with(kS, add(-0.9e-6)) == 0);
  CHECK(status_with(kS, add(-1.1e-6)) == 1);
  CHECK(status_with(kLimit, [](const std::string&) { return "chord"; }) == 1);
  CHECK(status_with(1, [](const std::string& line) { return line + "0"; }) == 1);
}

TEST_CASE("a recording of an earlier version, whose comments stand before the names, is replayed",
          "[apps][recording]") {
  const Folder folder;
  const std::string file = recorded(folder);
  Content held = content(file);
  const std::size_t comments = held.trace.find('#');
  const std::size_t rows = held.trace.find("\n0,", comments) + 1;
  REQUIRE(held.trace.substr(comments).starts_with("# schema: softcnc-trace 2\n"));
  held.trace = held.trace.substr(comments, rows - comments) + held.trace.substr(0, comments) +
               held.trace.substr(rows);
  held.trace.replace(held.trace.find("trace 2"), 7, "trace 1");
  json meta = json::parse(held.meta);
  meta["trace"]["hash"] = softcnc::hal::hash_hex(packed(held.trace));
  held.meta = meta.dump();
  pack(file, held);
  const Ended ended = call("replay " + file);
  CHECK(ended.status == 0);
  CHECK(ended.err.ends_with(" rows agree\n"));
}

TEST_CASE("rows that only one of the two has are a difference", "[apps][recording]") {
  const Folder folder;
  const std::string file = recorded(folder);
  const Content held = content(file);
  const std::size_t rows = parse_trace(held.trace).rows.size();

  Content shorter = held;
  shorter.trace.pop_back();
  shorter.trace.erase(shorter.trace.rfind('\n') + 1);
  pack(file, shorter);
  Ended ended = call("replay " + file);
  CHECK(ended.status == 1);
  CHECK(ended.out.starts_with(file + ": row " + std::to_string(rows) +
                              " is not in the recording, which ends earlier\n"));

  Content longer = held;
  longer.trace += longer.trace.substr(longer.trace.rfind('\n', longer.trace.size() - 2) + 1);
  pack(file, longer);
  ended = call("replay " + file);
  CHECK(ended.status == 1);
  CHECK(ended.out.starts_with(file + ": row " + std::to_string(rows + 1) +
                              " is recorded, but the replay ends earlier\n"));
}

TEST_CASE("another machine shows where it first differs", "[apps][recording]") {
  const Folder folder;
  const std::string file = recorded(folder);
  CHECK(call("replay -q " + file + " --set axis.x.acceleration_mm_s2=900").status == 1);
  write(folder / "two.toml", "[axis.x]\n[axis.y]\n");
  const Ended ended = call("replay " + file + " --machine " + (folder / "two.toml"));
  CHECK(ended.status == 1);
  CHECK(ended.out.find("the columns differ\n") != std::string::npos);
  CHECK(ended.err.find(file +
                       ": replayed on a machine other than that of the recording: its hash is ") !=
        std::string::npos);
}

TEST_CASE("the machine of the recording is not reported", "[apps][recording]") {
  const Folder folder;
  const std::string file = recorded(folder);
  CHECK(call("replay " + file).err.find("not on the machine") == std::string::npos);
  const Ended set = call("replay " + file + " --set axis.x.acceleration_mm_s2=900");
  CHECK(set.err.find("on a machine other than that of the recording") != std::string::npos);
}

TEST_CASE("a damaged recording is refused with SC6021, exit status 5", "[apps][recording]") {
  const Folder folder;
  const std::string file = recorded(folder);
  const std::string bytes = read(file);
  const auto refused = [&](const std::string& with) {
    const Ended ended = call("replay " + file);
    CAPTURE(ended.err, with);
    CHECK(ended.status == 5);
    CHECK(ended.out.empty());
    CHECK(begins_showing(ended.err, file + ": error: ... [SC6021]"));
    CHECK(ended.err.find(with) != std::string::npos);
    return ended.err;
  };
  write(file, "no recording");
  CHECK(refused("") ==
        file + ": error: cannot be read as a recording: Not a zip archive [SC6021]\n");
  write(file, bytes.substr(0, bytes.size() / 2));
  refused("cannot be read as a recording: ");
  std::string flipped = bytes;
  flipped[bytes.size() / 2] ^= 1;
  write(file, flipped);
  refused("");
  // One bit of the trace, in its first rows and its last ones: reported before any row is compared.
  const std::size_t trace = bytes.find("trace.csv.zst") + std::string("trace.csv.zst").size();
  const std::size_t directory = bytes.find("PK\x01\x02", trace);
  REQUIRE(directory != std::string::npos);
  for (const std::size_t at : {trace + 300, (trace + directory) / 2, directory - 40}) {
    flipped = bytes;
    flipped[at] ^= 4;
    write(file, flipped);
    refused("CRC");
  }

  write(file, bytes);
  const Content held = content(file);
  Content other = held;
  other.program += "\n";
  pack(file, other);
  refused("its program is not what was recorded: the hash differs");
  other = held;
  other.meta = "{";
  pack(file, other);
  refused("its meta.json is invalid: ");
  other = held;
  other.trace.insert(0, "# more\n");
  pack(file, other);
  refused("its trace.csv.zst is not what was recorded: the hash differs");
}

TEST_CASE("a recording of a later form is refused with SC6022", "[apps][recording]") {
  const Folder folder;
  const std::string file = recorded(folder);
  Content held = content(file);
  json meta = json::parse(held.meta);
  meta["schema"] = 3;
  held.meta = meta.dump();
  pack(file, held);
  const Ended ended = call("replay " + file);
  CHECK(ended.status == 5);
  CHECK(ended.err == file +
                         ": error: is a recording of schema 3; this version replays "
                         "schemas 1 to 2 [SC6022]\n");
}

namespace {

/// What replay says of a recording whose meta.json is changed by change(), without its hash put
/// right.
template <typename Change>
Ended replayed_with(const std::string& file, const Content& held, Change&& change) {
  auto meta = nlohmann::ordered_json::parse(held.meta);
  change(meta);
  ZipWriter zip(file);
  zip.add_text("meta.json", meta.dump(2) + '\n');
  zip.add_text("program", held.program);
  zip.add_text("machine.toml", held.machine);
  zip.add_text("state.toml", held.state);
  zip.add_text("trace.csv.zst", packed(held.trace));
  REQUIRE(zip.finish());
  return call("replay " + file);
}

}  // namespace

TEST_CASE("a meta.json that was changed is noticed", "[apps][recording]") {
  const Folder folder;
  const std::string file = recorded(folder);
  const Content held = content(file);
  CHECK(replayed_with(file, held, [&](auto& meta) {
          meta["trace"]["hash"] = softcnc::hal::hash_hex(packed(held.trace));
          meta = nlohmann::ordered_json::parse(softcnc::app::sealed_meta(meta.dump()));
        }).status == 0);
  const std::string differs =
      file + ": error: its meta.json is not what was recorded: the hash differs [SC6021]\n";
  CHECK(replayed_with(file, held, [](auto& meta) { meta["trace"]["rows"] = 7; }).err == differs);
  CHECK(replayed_with(file, held, [](auto& meta) { meta["more"] = 7; }).err == differs);
  CHECK(replayed_with(file, held, [](auto& meta) { meta["options"]["block_skip"] = true; }).err ==
        differs);
  CHECK(replayed_with(file, held, [](auto& meta) { meta.erase("hash"); }).status == 5);
  // Recordings of the first schema have no such hash; what they say of themselves is compared.
  const auto of_first = [&](auto&& change) {
    return replayed_with(file, held, [&](auto& meta) {
      meta["trace"]["hash"] = softcnc::hal::hash_hex(packed(held.trace));
      meta["schema"] = 1;
      meta.erase("hash");
      change(meta);
    });
  };
  CHECK(of_first([](auto&) {}).status == 0);
  CHECK(of_first([](auto& meta) { meta["trace"]["rows"] = -1; }).err ==
        file + ": error: its meta.json has an invalid number of rows: -1 [SC6021]\n");
  CHECK(
      begins_showing(of_first([](auto& meta) { meta["trace"]["rows"] = 7; }).err,
                     file + ": error: its meta.json promises 7 rows, its trace has ... [SC6021]"));
  CHECK(of_first([](auto& meta) { meta["trace"]["rows"] = 1e300; }).status == 5);
  CHECK(of_first([](auto& meta) { meta["options"]["feed_override"] = -1; }).status == 5);
  CHECK(of_first([](auto& meta) { meta["options"]["feed_override"] = 1e300; }).status == 5);
  CHECK(of_first([](auto& meta) { meta["schema"] = 1e300; }).status == 5);
}

TEST_CASE("a meta.json nested deeply, or naming a file twice, is refused", "[apps][recording]") {
  const Folder folder;
  const std::string file = recorded(folder);
  Content held = content(file);
  held.meta = "{\"schema\":1,\"a\":" + std::string(200'000, '[') + std::string(200'000, ']') + "}";
  pack(file, held);
  const Ended deep = call("replay " + file);
  CHECK(deep.status == 5);
  CHECK(deep.err == file + ": error: its meta.json is nested deeper than 16 levels [SC6021]\n");
  held.meta = std::string(1'000'000, '[');
  pack(file, held);
  CHECK(call("replay " + file).status == 5);
  auto meta = nlohmann::ordered_json::parse(content(recorded(folder)).meta);
  meta["called"] = {{{"name", "a"}, {"hash", ""}}, {{"name", "a"}, {"hash", ""}}};
  held.meta = meta.dump();
  pack(file, held);
  CHECK(call("replay " + file).err == file + ": error: names a called file twice: 'a' [SC6021]\n");
}

TEST_CASE("a recording of a few bytes that unpacks to a minute of reading is refused at once",
          "[apps][recording][code]") {
  const Folder folder;
  const std::string file = recorded(folder);
  Content bomb = content(file);
  std::string comments = "#\n";
  while (comments.size() < 100'000'000) comments += comments;
  bomb.trace = comments;
  json meta = json::parse(bomb.meta);
  meta["trace"]["hash"] = softcnc::hal::hash_hex(packed(bomb.trace));
  bomb.meta = meta.dump();
  pack(file, bomb);  // compresses what is compressed
  REQUIRE(read(file).size() < 20'000);
  const Ended ended = call("replay " + file);
  CHECK(ended.status == 5);
  CHECK(ended.err ==
        file + ": error: its trace unpacks to more than 2000 times its size [SC6024]\n");
}

TEST_CASE("a recording of too many entries is refused", "[apps][recording]") {
  const Folder folder;
  const std::string file = folder / "many.rec";
  ZipWriter zip(file);
  for (int i = 0; i < 10'001; ++i) zip.add_text("called/" + std::to_string(i), "");
  REQUIRE(zip.finish());
  CHECK(call("replay " + file).err == file + ": error: has more than 10000 entries [SC6024]\n");
}

TEST_CASE("what is not finite in a recorded trace is no number of a run", "[apps][recording]") {
  const Folder folder;
  const std::string file = recorded(folder);
  const Content held = content(file);
  for (const std::string value : {"inf", "-inf", "nan", "1e999"}) {
    for (const std::size_t column : {kS, kX, std::size_t{4}, std::size_t{5}}) {
      CAPTURE(value, column);
      Content other = held;
      other.trace = changed(held.trace, 200, column, [&](const std::string&) { return value; });
      json meta = json::parse(held.meta);
      meta["trace"]["hash"] = softcnc::hal::hash_hex(packed(other.trace));
      other.meta = meta.dump();
      pack(file, other);
      CHECK(call("replay -q " + file).status == 1);
    }
  }
}

TEST_CASE("a recording may come from standard input where that is a file", "[apps][recording]") {
  const Folder folder;
  const std::string file = recorded(folder);
  const Ended ended = shell("$softcnc replay - < " + file);
  CHECK(ended.status == 0);
  CHECK(ended.err.starts_with("<stdin>: "));
  const std::string refused =
      ": error: cannot be read as a recording: it is not a regular file, which a recording must "
      "be [SC6021]\n";
  CHECK(shell("$softcnc replay - < /dev/null").err == "<stdin>" + refused);
  CHECK(shell("cat " + file + " | $softcnc replay -").err == "<stdin>" + refused);
  CHECK(call("replay /dev/null").err == "/dev/null" + refused);
  CHECK(call("replay /dev/null").status == 5);
}

TEST_CASE("a recording that cannot be made leaves no file", "[apps][recording]") {
  const Folder folder;
  CHECK(call("record -q $data/two_errors.nc -o " + (folder / "x.rec")).status == 1);
  CHECK(folder.files().empty());
  CHECK(call("record -q $data/square.nc -o /dev/full").status == 5);
  const Ended nowhere = call("record $data/square.nc -o " + (folder / "no/x.rec"));
  CHECK(nowhere.status == 5);  // and no summary: nothing has moved
  CHECK(nowhere.err ==
        (folder / "no/x.rec") + ": error: cannot be created: No such file or directory [SC6011]\n");
  CHECK(shows(
      shell("TMPDIR=/no/folder $softcnc record -q $data/square.nc -o " + (folder / "x.rec")).err,
      "error: ... [SC6003]"));
  CHECK(folder.files().empty());
}

TEST_CASE("several recordings are replayed though one differs", "[apps][recording]") {
  const Folder folder;
  const std::string file = recorded(folder);
  write(folder / "bad.rec", "no recording");
  const Ended ended = call("replay " + (folder / "bad.rec") + " " + file);
  CHECK(ended.status == 5);
  CHECK(ended.err.find("rows agree") != std::string::npos);
}

TEST_CASE("a recording holds the files that its program called", "[apps][recording]") {
  const Folder folder;
  const std::string program = folder / "main.nc", file = folder / "main.rec";
  write(program, "o<step> call [5]\no<step> call [8]\nM30\n");
  write(folder / "step.ngc", "o<step> sub\nG0 X#1\no<step> endsub\n");
  write(folder / "other.ngc", "o<other> sub\no<other> endsub\n");
  REQUIRE(call("record -q " + program + " -o " + file).status == 0);
  CHECK(entry(file, "called/step.ngc") == read(folder / "step.ngc"));
  const json called = json::parse(entry(file, "meta.json"))["called"];
  REQUIRE(called.size() == 1);
  CHECK(called[0]["name"] == "step.ngc");
  CHECK(called[0]["hash"] == softcnc::hal::hash_hex(read(folder / "step.ngc")));
  write(folder / "step.ngc", "o<step> sub\nG0 X[#1+1]\no<step> endsub\n");
  const Ended same = call("replay " + file);
  CHECK(same.status == 0);
}

TEST_CASE("what happens in a called file is reported with its name", "[apps][check]") {
  const Folder folder;
  write(folder / "main.nc", "o<far> call\nM30\n");
  write(folder / "far.ngc", "(far away)\no<far> sub\nG0 X2000\no<far> endsub\n");
  const Ended ended = call("check " + (folder / "main.nc"));
  CHECK(ended.status == 3);
  CHECK(shows(ended.out, folder / "far.ngc:3:1: error: ... [SC4001]"));
  CHECK(ended.out.find("    3 | G0 X2000\n") != std::string::npos);
}

TEST_CASE("a program that goes back comes through a pipe", "[apps][blocks]") {
  std::string text = "o1 sub\nG0 X#1\no1 endsub\n";
  for (int i = 0; i < 20000; ++i) text += "G0 X1 (a line that is read once)\n";
  text += "#2=0\no2 repeat [3]\n#2=[#2+2]\no1 call [#2]\no2 endrepeat\nM30\n";
  const Ended ended = call("blocks -", text);
  CHECK(ended.status == 0);
  CHECK(ended.out.ends_with(
      "\"to\":[6,0,0]}\n{\"line\":20009,\"block\":5,\"kind\":\"end\",\"code\":30}\n"));
}
