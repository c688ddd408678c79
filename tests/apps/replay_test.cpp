// SPDX-License-Identifier: MIT
// replay of many recordings: folders, shards, results for programs, and --bless.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "apps/recording_entries.hpp"
#include "apps/shell.hpp"
#include "hal/files/zip_file.hpp"
#include "replay/recording_list.hpp"
#include "replay/replay_report.hpp"
#include "support/shown.hpp"
#include "support/zstd.hpp"

using namespace softcnc::app;
using namespace softcnc::app::test;
using nlohmann::json;
using softcnc::hal::ZipReader;
using softcnc::hal::ZipWriter;

namespace {

namespace fs = std::filesystem;

void record(const std::string& file, const std::string& program, const std::string& options = "") {
  fs::create_directories(fs::path(file).parent_path());
  const std::string part = file + ".nc";
  write(part, program);
  const Ended ended = call("record -q " + part + " -o " + file + " " + options);
  CAPTURE(ended.err);
  REQUIRE(ended.status == 0);
  fs::remove(part);
}

/// Changes x_mm of a row of the trace in a recording.
void change_trace(const std::string& file, std::size_t row) {
  const auto zip = ZipReader::open(file);
  REQUIRE(zip);
  std::string text = softcnc::test::unpacked(entry(*zip, "trace.csv.zst"));
  std::size_t at = 0;
  for (std::size_t i = 0; i < 4 + row; ++i) at = text.find('\n', at) + 1;
  for (int column = 0; column < 7; ++column) at = text.find(',', at) + 1;
  text.insert(at, "7");
  const std::string again = softcnc::test::packed(text);
  ZipWriter writer(file + ".new");
  for (const std::string& name : zip->names())
    writer.add_text(name, name == "trace.csv.zst" ? again : entry(*zip, name));
  REQUIRE(writer.finish());
  fs::rename(file + ".new", file);
}

const std::string kLine = "G01 X5 F1200\nM30\n";

/// Five recordings, of which b/2.rec differs where it is changed.
void make_folder(const Folder& folder) {
  for (const char* name : {"z.rec", "a.rec", "b/2.rec", "b/10.rec", "b/c/x.rec"})
    record(folder / name, kLine);
  write(folder / "b/notes.txt", "no recording");
}

json results(const std::string& arguments, int status) {
  const Ended ended = call("replay -q --format json " + arguments);
  CAPTURE(ended.err);
  REQUIRE(ended.status == status);
  return json::parse(ended.out);
}

std::vector<std::string> names(const json& document) {
  std::vector<std::string> names;
  for (const json& one : document["recordings"]) names.push_back(one["file"]);
  return names;
}

}  // namespace

TEST_CASE("a folder stands for the recordings below it, in order", "[apps][replay]") {
  const Folder folder;
  make_folder(folder);
  const std::string all = folder / "";
  const json document = results(all, 0);
  CHECK(names(document) == std::vector<std::string>{folder / "a.rec", folder / "b/10.rec",
                                                    folder / "b/2.rec", folder / "b/c/x.rec",
                                                    folder / "z.rec"});
  CHECK(document["agree"] == 5);
  const Ended quiet = call("replay " + all);
  CHECK(quiet.out.empty());
  CHECK(quiet.err == "5 of 5 recordings agree\n");
  const Ended verbose = call("replay -v " + all);
  CHECK(verbose.err.find("b/2.rec: ") != std::string::npos);
  const Ended mixed = call("replay " + (folder / "z.rec") + " " + (folder / "b"));
  CHECK(mixed.err.ends_with("4 of 4 recordings agree\n"));
}

TEST_CASE("recordings that differ or are damaged are counted, and the others replayed",
          "[apps][replay]") {
  const Folder folder;
  make_folder(folder);
  change_trace(folder / "b/2.rec", 100);
  write(folder / "bad.rec", "no recording");
  const Ended ended = call("replay " + (folder / ""));
  CHECK(ended.status == 5);
  CHECK(ended.out.find("b/2.rec: row 100 differs\n") != std::string::npos);
  CHECK(ended.err.ends_with("4 of 6 recordings agree; 1 differs; 1 could not be replayed\n"));
  fs::remove(folder / "bad.rec");
  const json document = results(folder / "", 1);
  CHECK(document["agree"] == 4);
  CHECK(document["differ"] == 1);
  const json& differs = document["recordings"][2];
  CHECK(differs["result"] == "differs");
  CHECK(differs["code"] == "SC6023");
  CHECK(differs["message"].get<std::string>().starts_with("row 100 differs: at 0.099 s, line 1"));
  CHECK(differs["rows"] == 99);
}

TEST_CASE("a folder without recordings is an error", "[apps][replay][code]") {
  const Folder folder;
  const std::string empty = folder / "empty";
  fs::create_directories(empty);
  const Ended ended = call("replay " + empty);
  CHECK(ended.status == 5);
  CHECK(ended.err == empty + ": error: has no recordings: no file ends in .rec [SC6025]\n");
}

TEST_CASE("shards have nothing in common, and are all recordings together", "[apps][replay]") {
  std::vector<ListedRecording> list;
  for (int i = 0; i < 47; ++i) list.push_back({std::to_string(i), true});
  for (const int shards : {1, 2, 5, 46, 47, 60}) {
    std::multiset<std::string> together;
    std::size_t largest = 0, smallest = list.size();
    for (int shard = 1; shard <= shards; ++shard) {
      const auto part = shard_of(list, shard, shards);
      for (const ListedRecording& recording : part) together.insert(recording.file);
      largest = std::max(largest, part.size());
      smallest = std::min(smallest, part.size());
    }
    CHECK(together.size() == list.size());
    CHECK(std::set<std::string>(together.begin(), together.end()).size() == list.size());
    CHECK(largest - smallest <= 1);
  }
}

TEST_CASE("shards of a folder are replayed", "[apps][replay]") {
  const Folder folder;
  make_folder(folder);
  std::vector<std::string> together;
  for (const char* shard : {"1/3", "2/3", "3/3"})
    for (const std::string& name : names(results((folder / "") + " --shard " + shard, 0)))
      together.push_back(name);
  std::sort(together.begin(), together.end());
  CHECK(together == names(results(folder / "", 0)));
  CHECK(results((folder / "") + " --shard 6/6", 0)["recordings"].empty());
  CHECK(call("replay " + (folder / "") + " --shard 6/6").err == "0 of 0 recordings agree\n");
  for (const char* wrong : {"0/3", "4/3", "1", "1/", "/3", "a/b", "1/3x", "-1/3", "1/0"}) {
    const Ended refused = call("replay x.rec --shard " + std::string(wrong));
    CHECK(refused.status == 2);
    CHECK(refused.err.find("takes K/N, with K from 1 to N") != std::string::npos);
  }
}

TEST_CASE("a recording that differs is made again, and then agrees", "[apps][replay]") {
  const Folder folder;
  make_folder(folder);
  const std::string changed = folder / "b/2.rec", before = read(changed);
  const std::string other = read(folder / "a.rec");
  change_trace(changed, 100);
  fs::permissions(changed, fs::perms::owner_read | fs::perms::owner_write);
  const Ended ended = call("replay --bless " + (folder / ""));
  CHECK(ended.status == 0);
  CHECK(shows(ended.err, "b/2.rec: made again: row 100 differs: at 0.099 s, line 1, x_mm is ..."));
  CHECK(ended.err.ends_with("4 of 5 recordings agree; 1 differed and is made again\n"));
  CHECK(read(changed) == before);  // the same bytes as those of a recording of this version
  CHECK(read(folder / "a.rec") == other);
  CHECK((fs::status(changed).permissions() & fs::perms::all) ==
        (fs::perms::owner_read | fs::perms::owner_write));
  CHECK(call("replay " + (folder / "")).err == "5 of 5 recordings agree\n");
  CHECK(folder.files().size() == 3);
}

TEST_CASE("a recording with called files and options is made again with them", "[apps][replay]") {
  const Folder folder;
  const std::string file = folder / "m.rec";
  write(folder / "step.ngc", "o<step> sub\nG1 X#1 F900\no<step> endsub\n");
  record(file, "o<step> call [5]\n/G1 X9\nM30\n", "--block-skip --feed-override 50");
  const std::string before = read(file);
  fs::remove(folder / "step.ngc");
  change_trace(file, 50);
  CHECK(call("replay -q --bless " + file).status == 0);
  CHECK(read(file) == before);
  CHECK(call("replay -q " + file).status == 0);
}

TEST_CASE("nothing is made again that is damaged or whose run fails", "[apps][replay][code]") {
  const Folder folder;
  const std::string file = folder / "a.rec";
  record(file, kLine);
  std::string damaged = read(file);
  damaged[damaged.size() / 2] ^= 4;
  write(file, damaged);
  CHECK(call("replay -q --bless " + file).status == 5);
  CHECK(read(file) == damaged);

  // A following error stops the axis: the recording is of a run that ends by an alarm.
  const std::string alarm = folder / "alarm.rec";
  write(folder / "p.nc", "G01 X50 F6000\nM30\n");
  const Ended recorded = call("record -q " + (folder / "p.nc") + " -o " + alarm +
                              " --set axis.x.drive.following_error_um=500");
  REQUIRE(recorded.status == 4);
  change_trace(alarm, 5);
  const std::string changed = read(alarm);
  const Ended ended = call("replay -q --bless " + alarm);
  CHECK(ended.status == 5);
  CHECK(ended.err == alarm + ": error: is not made again: its run ends by an alarm [SC6026]\n");
  CHECK(read(alarm) == changed);
}

TEST_CASE("recordings are made again on their own machines only", "[apps][replay]") {
  CHECK(call("replay --bless x.rec --set axis.x.acceleration_mm_s2=900").status == 2);
  CHECK(call("replay --bless x.rec --machine builtin").status == 2);
  CHECK(call("replay --bless -").status == 2);
}

TEST_CASE("no recording of a folder is overwritten by results", "[apps][replay]") {
  const Folder folder;
  make_folder(folder);
  const std::string before = read(folder / "b/2.rec");
  CHECK(call("replay -q " + (folder / "") + " --junit " + (folder / "b/2.rec")).status == 2);
  CHECK(read(folder / "b/2.rec") == before);
}

TEST_CASE("each recording is a test case of a JUnit file", "[apps][replay]") {
  const Folder folder;
  make_folder(folder);
  change_trace(folder / "b/2.rec", 100);
  write(folder / "bad.rec", "no recording");
  const std::string file = folder / "j.xml";
  CHECK(call("replay -q " + (folder / "") + " --junit " + file).status == 5);
  const std::string xml = read(file);
  CHECK(xml.find("<testsuite name=\"softcnc replay\" tests=\"6\" failures=\"1\" errors=\"1\" "
                 "skipped=\"0\" time=\"") != xml.npos);
  CHECK(xml.find("<failure message=\"row 100 differs: at 0.099 s, line 1") != xml.npos);
  CHECK(xml.find("type=\"SC6023\">row 100 differs&#10;") != xml.npos);
  CHECK(xml.find("<error message=\"cannot be read as a recording: Not a zip archive\" "
                 "type=\"SC6021\">") != xml.npos);
}

TEST_CASE("results are counted in one sentence", "[apps][replay]") {
  const auto with = [](std::vector<ReplayEnd> ends) {
    std::vector<ReplayResult> results;
    for (const ReplayEnd end : ends) results.emplace_back().end = end;
    return replay_summary(results);
  };
  using enum ReplayEnd;
  CHECK(with({agrees}) == "1 of 1 recording agrees");
  CHECK(with({agrees, differs}) == "1 of 2 recordings agrees; 1 differs");
  CHECK(with({agrees, agrees, differs, differs, blessed, error}) ==
        "2 of 6 recordings agree; 2 differ; 1 differed and is made again; 1 could not be replayed");
}
