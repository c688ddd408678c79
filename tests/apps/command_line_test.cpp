// SPDX-License-Identifier: MIT
// What the program understands, and how it reports what it does not.
#include <catch2/catch.hpp>

#include "apps/shell.hpp"
#include "support/shown.hpp"

using namespace softcnc::app::test;

namespace {

const std::string kKnown =
    "; the commands are run, check, blocks, convert, operate, serve, record, replay, diff, report, "
    "surface, compare, circle, identify, machine, state, latency, pulses, codes\nRun with --help "
    "for more information.\n";

}  // namespace

TEST_CASE("without a command there is a hint, and exit status 2", "[apps][cli]") {
  const Ended ended = call("");
  CHECK(ended.status == 2);
  CHECK(ended.out.empty());
  CHECK(ended.err == "a command is missing" + kKnown);
}

TEST_CASE("a word that is no command is named, with the commands and the nearest", "[apps][cli]") {
  const auto refused = [](const std::string& words) {
    const Ended ended = call(words);
    CHECK(ended.status == 2);
    CHECK(ended.out.empty());
    return ended.err;
  };
  CHECK(refused("rum p.nc") == "'rum' is not a command; did you mean 'run'?" + kKnown);
  CHECK(refused("chekc p.nc") == "'chekc' is not a command; did you mean 'check'?" + kKnown);
  CHECK(refused("recard p.nc") == "'recard' is not a command; did you mean 'record'?" + kKnown);
  CHECK(refused("simulate p.nc") == "'simulate' is not a command" + kKnown);
  CHECK(refused("--loud") == "--loud: a command is missing" + kKnown);
  CHECK(refused("part.nc") == "'part.nc' is not a command; 'softcnc run part.nc' runs it" + kKnown);
  CHECK(refused("- --dry-run") == "'-' is not a command; 'softcnc run -' runs it" + kKnown);
}

TEST_CASE("of a name that an option does not know the nearest is named", "[apps][cli]") {
  CHECK(shows(call("run --dialect fanux p.nc").err,
              "'fanux' is not one of linuxcnc, fanuc, haas, grbl, auto; did you mean 'fanuc'?"));
  CHECK(shows(call("run --backend hal-streams p.nc").err, "; did you mean 'hal-stream'?"));
  CHECK(shows(call("check --diagnostics xml p.nc").err, "'xml' is not one of text, json, sarif\n"));
}

TEST_CASE("help and version are data: stdout, exit status 0", "[apps][cli]") {
  CHECK(call("--version").out.starts_with("softcnc " SOFTCNC_VERSION " ("));
  CHECK(call("-V").out == call("--version").out);
  CHECK(call("help run").out == call("run --help").out);
  CHECK(call("help").out == call("--help").out);
  CHECK(shows(call("help chek").err, "'chek' is not a command; did you mean 'check'?"));
  for (const char* command :
       {"", "run", "check", "blocks", "record", "replay", "surface", "compare", "circle", "convert",
        "identify", "machine", "latency", "pulses", "codes"}) {
    CAPTURE(command);
    const Ended ended = call(std::string(command) + " --help");
    CHECK(ended.status == 0);
    CHECK(ended.err.empty());
    CHECK(ended.out.find("Usage: softcnc") != std::string::npos);
  }
}

TEST_CASE("what is wrong with a command line is said in softcnc's words", "[apps][cli]") {
  const auto said_of = [](const std::string& arguments) {
    const std::string text = call(arguments).err;
    return text.substr(0, text.find('\n'));
  };
  CHECK(said_of("check") == "PART is missing");
  CHECK(said_of("run a.nc b.nc") == "PART: one is taken, and 2 are given");
  CHECK(said_of("run --at") == "--at needs SECONDS:WHAT");
  CHECK(said_of("run x.nc --worst x") == "--worst: 'x' is not a number from 1 to 1000000");
  CHECK(said_of("run x.nc --feed-override a") == "--feed-override: 'a' is not a number");
  CHECK(said_of("diff a.nc") == "FILE: 2 are needed, and 1 is given");
  CHECK(said_of("run x.nc -q -v") == "--quiet and --verbose exclude each other");
  CHECK(said_of("run x.nc --subprograms /none") == "--subprograms: there is no folder '/none'");
}

TEST_CASE("help has groups and three examples, and each example names the command", "[apps][cli]") {
  for (const std::string command :
       {"run", "check", "blocks", "convert", "record", "replay", "diff", "report", "surface",
        "compare", "circle", "identify", "machine", "latency", "pulses", "codes"}) {
    const std::string help = call(command + " --help").out;
    CAPTURE(command);
    const std::size_t examples = help.find("\nExamples:\n  softcnc " + command);
    REQUIRE(examples != help.npos);
    CHECK(help.find("\nMessages:\n") < examples);
    CHECK(help.find("\n\n\n") == help.npos);
  }
}

TEST_CASE("check takes folders and reads the programs below them", "[apps][check]") {
  const Folder folder;
  REQUIRE(shell("mkdir -p " + (folder / "a/b") + " " + (folder / "empty")).status == 0);
  write(folder / "a/2.nc", "G1 X1\nM2\n");
  write(folder / "a/b/1.NGC", "G999\nM2\n");
  write(folder / "a/notes.txt", "no program\n");
  const Ended ended = shell("cd " + (folder / "") + "; $softcnc check a");
  CHECK(ended.status == 1);
  const std::size_t first = ended.out.find("a/2.nc:1:1: error"),
                    last = ended.out.find("a/b/1.NGC:1:1");
  CHECK((first != ended.out.npos && last != ended.out.npos && first < last));
  CHECK_FALSE(shows(ended.out, "notes.txt"));
  CHECK(shows(call("check " + (folder / "empty")).out, "the folder holds no part program"));
  const Ended beside = call("check " + (folder / "empty") + " $data/two_errors.nc");
  CHECK(beside.status == 5);
  CHECK(shows(beside.out, "two_errors.nc:... error: "));
  CHECK(shows(call("check --diagnostics json " + (folder / "empty")).out, "SC6001"));
}

TEST_CASE("what does not exist is refused as wrong usage", "[apps][cli]") {
  for (const char* option :
       {"--real-time", "--from-line 3", "--dialect siemens", "--diagnostics xml", "--watch",
        "--backend printer", "--progress maybe", "--quiet --verbose", "--set"}) {
    CAPTURE(option);
    const Ended ended = call(std::string("run $data/square.nc ") + option);
    CHECK(ended.status == 2);
    CHECK(ended.out.empty());
    CHECK(ended.err.find("Run with --help for more information.") != std::string::npos);
  }
  for (const char* command :
       {"report x", "surface x", "latency x", "run", "check", "replay", "compare", "identify",
        "record $data/square.nc", "run a.nc b.nc", "machine x"}) {
    CAPTURE(command);
    CHECK(call(command).status == 2);
  }
}

TEST_CASE("the option --dialect says whose reading counts", "[apps][cli]") {
  const std::string part = "G04 P250\nM30\n";
  CHECK(call("blocks -", part).out.find("\"duration_s\":250}") != std::string::npos);
  CHECK(call("blocks --dialect linuxcnc -", part).out == call("blocks -", part).out);
  CHECK(call("blocks --dialect=fanuc -", part).out.find("\"duration_s\":0.25}") !=
        std::string::npos);
  CHECK(call("blocks --dialect haas -", part).out == call("blocks --dialect fanuc -", part).out);
  CHECK(call("blocks --dialect grbl -", part).out == call("blocks -", part).out);
  CHECK(call("blocks --dialect auto -", "#1=#2+1\n" + part).out.find("\"duration_s\":0.25}") !=
        std::string::npos);
  CHECK(parse_trace(call("run -q --dry-run --dialect fanuc -", part).out).rows.size() == 251);
  const std::string missing = "G04\nM30\n";
  CHECK(call("check --dialect fanuc -", missing).out.find("the time in milliseconds, or X or U") !=
        std::string::npos);
  CHECK(call("check -", missing).out.find("the time in seconds [") != std::string::npos);
}

TEST_CASE("the input of paper 003 is known by its first line, or by --format", "[apps][cli]") {
  const std::string part = "f 600\nl 10 0\npccw 0 4 0 2\n";
  const std::string blocks = call("blocks -", part).out;
  CHECK(blocks.find("{\"line\":2,\"block\":1,\"kind\":\"feed\",\"from\":[0,0,0],\"to\":[10,0,0],"
                    "\"feed_mm_s\":10}\n") == 0);
  CHECK(call("blocks --format commands -", part).out == blocks);
  CHECK(call("check -", part).out.empty());
  const Trace trace = parse_trace(call("run -q --dry-run -", part).out);
  CHECK(trace.rows.back()[9] == "0");
  CHECK(trace.rows.back()[7] == "10");
  CHECK(trace.rows.back()[8] == "4");
  CHECK(call("check --format commands -", "f 600\nl 10\n").out ==
        "<stdin>:2:1: error: l takes 2 to 3 numbers, dx dy [dz]; here is 1 [SC1052]\n"
        "    2 | l 10\n"
        "      | ^~~~\n");
  CHECK(call("check --format gcode -", part).status == 1);
  CHECK(call("check --format paper -", part).status == 2);
}

TEST_CASE("an unknown option is named, whatever follows it", "[apps][cli]") {
  for (const char* words : {"--real-time", "--from-line 3", "--from-line=3",
                            "--set control.backend=sim --watch", "-x"}) {
    CAPTURE(words);
    const std::string all = words;
    const std::size_t begin = all.starts_with("--set") ? all.rfind("--") : 0;
    const std::string name = all.substr(begin, all.find_first_of(" =", begin) - begin);
    const std::string meant = name == "--real-time" ? "; did you mean '--realtime'?" : "";
    const std::string says =
        name + ": no such option of 'run'" + meant + "\nRun with --help for more information.\n";
    const Ended after = call("run $data/square.nc " + all);
    CHECK(after.status == 2);
    CHECK(after.err == says);
    CHECK(call("run " + all + " $data/square.nc").err == says);
  }
  CHECK(call("run $data/square.nc x.nc --feed-override -5").err.find("no such option") ==
        std::string::npos);
}

TEST_CASE("a file is not named twice where it would be overwritten", "[apps][cli]") {
  const Folder folder;
  const std::string part = folder / "p.csv", link = folder / "link.csv", fresh = folder / "new.csv";
  write(part, "G01 X1 F600\nM30\n");
  CHECK(shell("ln " + part + " " + link).status == 0);
  const auto refused = [&](const std::string& arguments) {
    CAPTURE(arguments);
    const Ended ended = call(arguments);
    CHECK(ended.status == 2);
    CHECK(ended.err.find(" name the same file: ") != std::string::npos);
    CHECK(read(part) == "G01 X1 F600\nM30\n");
    CHECK(folder.files() == std::vector<std::string>{"link.csv", "p.csv"});
  };
  refused("run " + part + " --trace " + part);
  refused("run " + part + " --trace " + link);
  refused("run " + part + " --report " + part);
  refused("run $data/square.nc --machine " + part + " --trace " + part);
  refused("run " + part + " --trace " + fresh + " --report " + (folder / "./new.csv"));
  refused("record " + part + " -o " + part);
  refused("record " + part + " -o " + fresh + " --report " + fresh);
  CHECK(call("run -q " + part + " --trace /dev/null --report /dev/null").status == 0);
}

TEST_CASE("a feed override outside 0 to 200 percent is refused", "[apps][cli]") {
  for (const char* percent : {"0", "-5", "201", "nan", "abc"}) {
    CAPTURE(percent);
    CHECK(call(std::string("run -q $data/square.nc --feed-override ") + percent).status == 2);
  }
  CHECK(call("run $data/square.nc --feed-override 0").err ==
        "--feed-override: takes a percentage above 0 and at most 200\n"
        "Run with --help for more information.\n");
}

TEST_CASE("a missing part program ends with 5, a missing machine file with 2", "[apps][cli]") {
  for (const char* command : {"run", "run --dry-run", "blocks", "record -o x.rec"}) {
    CAPTURE(command);
    const Ended ended = call(std::string(command) + " missing.nc");
    CHECK(ended.status == 5);
    CHECK(ended.out.empty());
    CHECK(ended.err == "missing.nc: error: cannot be read: No such file or directory [SC6001]\n");
  }
  for (const char* command : {"run", "blocks", "record -o x.rec"}) {
    CAPTURE(command);
    const Ended ended = call(std::string(command) + " missing.nc --machine missing.toml");
    CHECK(ended.status == 2);
    CHECK(begins_showing(ended.err, "missing.toml: error: ... [SC7003]"));
  }
  CHECK(call("machine --machine missing.toml").status == 2);
  CHECK(call("replay missing.rec --machine missing.toml").status == 2);
}

TEST_CASE("a folder is no part program", "[apps][cli]") {
  const Ended ended = call("run $data");
  CHECK(ended.status == 5);
  CHECK(shows(ended.err, "error: cannot be read: Is a directory... [SC6001]"));
}

TEST_CASE("full disks and closed pipes are distinguished", "[apps][cli]") {
  for (const char* command :
       {"run -q --dry-run $data/square.nc", "blocks $data/square.nc", "machine", "--help",
        "run --help", "--version", "check $data/two_errors.nc"}) {
    CAPTURE(command);
    const Ended full = call(std::string(command) + " >/dev/full");
    CHECK(full.status == 5);
    CHECK(full.err == "<stdout>: error: writing failed: No space left on device [SC6012]\n");
    const Ended closed =
        shell(std::string("{ sleep 0.2; $softcnc ") + command + "; echo $? >&2; } | :");
    CHECK(closed.err == "141\n");
  }
}

TEST_CASE("a trace on a full disk ends with 5, and no file is left", "[apps][cli]") {
  const Folder folder;
  const Ended ended = call("run -q $data/square.nc --trace /dev/full");
  CHECK(ended.status == 5);
  CHECK(ended.err == "/dev/full: error: writing failed: No space left on device [SC6012]\n");
  CHECK(call("run -q $data/square.nc --report /dev/full").status == 5);
  CHECK(call("run -q $data/square.nc --trace " + (folder / "no/folder.csv")).status == 5);
  CHECK(call("run -q $data/square.nc --trace " + (folder / "trace.xyz")).err.find("SC6014") !=
        std::string::npos);
  CHECK(folder.files().empty());
}
