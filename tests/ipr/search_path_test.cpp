// SPDX-License-Identifier: MIT
// Where files of subprograms are looked for beyond the folder of the program.
#include <catch2/catch.hpp>
#include <filesystem>

#include "ipr/ends.hpp"
#include "ipr/interpret.hpp"
#include "support/folder.hpp"
#include "support/shown.hpp"

namespace softcnc::ipr {
namespace {

using test::Folder;

std::string sub(const std::string& name, int x) {
  return "o<" + name + "> sub\nG0 X" + std::to_string(x) + "\no<" + name + "> endsub\n";
}

/// A folder with a program's folder "part" and folders of subprograms beside it.
class Shop : public Folder {
 public:
  Shop() {
    for (const char* folder : {"part", "lib", "more"})
      std::filesystem::create_directory(*this / folder);
  }

  Interpreted run(const std::string& text, const std::vector<std::string>& folders,
                  const std::vector<std::string>& of_machine = {},
                  Dialect dialect = Dialect::linuxcnc) const {
    InterpreterOptions options;
    options.dialect = dialect;
    options.folder = *this / "part";
    options.called = called;
    for (const std::string& folder : folders) options.subprogram_folders.push_back(*this / folder);
    Machine machine;
    machine.program.path = of_machine;
    machine.program.path_base = path();
    return interpret(text, machine, options);
  }

  CalledTexts* called = nullptr;
};

std::string rendered(const Interpreted& result) {
  std::string text;
  for (const Diagnostic& diagnostic : result.diagnostics) text += render(diagnostic);
  return text;
}

const std::string kCall = "o<hole> call\nM2\n";

}  // namespace

TEST_CASE("the folder of the program comes first, then those of the user, then the machine's",
          "[ipr][search]") {
  Shop shop;
  shop.with("lib/hole.ngc", sub("hole", 3));
  CHECK(last_x(shop.run(kCall, {}, {"lib"})) == 3);
  shop.with("more/hole.ngc", sub("hole", 2));
  CHECK(last_x(shop.run(kCall, {}, {"lib", "more"})) == 3);
  CHECK(last_x(shop.run(kCall, {"more"}, {"lib"})) == 2);
  CHECK(last_x(shop.run(kCall, {"more", "lib"})) == 2);
  shop.with("part/hole.ngc", sub("hole", 1));
  CHECK(last_x(shop.run(kCall, {"more"}, {"lib"})) == 1);
}

TEST_CASE("whole paths of the machine count from nowhere", "[ipr][search]") {
  Shop shop;
  shop.with("lib/hole.ngc", sub("hole", 3));
  CHECK(last_x(shop.run(kCall, {}, {shop / "lib"})) == 3);
}

TEST_CASE("programs with numbers are found under the same names as beside the program",
          "[ipr][search]") {
  for (const char* name : {"O1234", "O1234.nc", "o1234.ngc", "1234"}) {
    Shop shop;
    shop.with(std::string("lib/") + name, "O1234\nG0 X7\nM99\n");
    CAPTURE(name);
    CHECK(last_x(shop.run("M98 P1234\nM30\n", {"lib"}, {}, Dialect::fanuc)) == 7);
  }
  Shop shop;
  shop.with("lib/O0012.nc", "O0012\nG0 X8\nM99\n");
  CHECK(last_x(shop.run("G65 P12\nM30\n", {"lib"}, {}, Dialect::fanuc)) == 8);
}

TEST_CASE("a program without a folder finds its subprograms on the search path", "[ipr][search]") {
  Shop shop;
  shop.with("lib/hole.ngc", sub("hole", 3));
  InterpreterOptions options;
  options.subprogram_folders = {shop / "lib"};
  CHECK(last_x(interpret(kCall, {}, options)) == 3);
}

TEST_CASE("a file of the search path calls others of it", "[ipr][search]") {
  Shop shop;
  shop.with("lib/hole.ngc", "o<hole> sub\no<deep> call\no<hole> endsub\n");
  shop.with("more/deep.ngc", sub("deep", 5));
  CHECK(last_x(shop.run(kCall, {"lib", "more"})) == 5);
}

TEST_CASE("a file that does not have its subprogram does not hide one in a later folder",
          "[ipr][search]") {
  Shop shop;
  shop.with("lib/hole.ngc", sub("other", 4));
  shop.with("more/hole.ngc", sub("hole", 5));
  CHECK(last_x(shop.run(kCall, {"lib", "more"})) == 5);
}

TEST_CASE("a call that finds nothing says where it has looked", "[ipr][search]") {
  Shop shop;
  const std::string lib = shop / "lib", more = shop / "more", gone = shop / "gone";
  CHECK(shows(rendered(shop.run(kCall, {})),
              "1:1: error: no subprogram o<hole> in this program or beside it [SC2301]"));
  CHECK(shows(rendered(shop.run(kCall, {"lib"}, {"more", "gone"})),
              "1:1: error: no subprogram o<hole> in this program, beside it, in " + lib + ", in " +
                  more + " or in " + gone + " (no such folder) [SC2301]"));
  CHECK(shows(rendered(shop.run(kCall, {"lib", "lib", "lib", "lib", "lib", "lib"})),
              "in " + lib + " or in 2 more folders [SC2301]"));
  InterpreterOptions options;
  options.subprogram_folders = {lib};
  CHECK(shows(rendered(interpret(kCall, {}, options)),
              "no subprogram o<hole> in this program or in " + lib + " [SC2301]"));
}

TEST_CASE("no call leads out of a folder of the search path", "[ipr][search]") {
  Shop shop;
  shop.with("more/hole.ngc", sub("hole", 5));
  const auto fails = [&](const std::string& call) {
    return shows(rendered(shop.run(call + "\nM2\n", {"lib"})), "[SC2301]");
  };
  CHECK(fails("o<../more/hole> call"));
  CHECK(fails("o<" + (shop / "more/hole") + "> call"));
  std::filesystem::create_symlink("../more/hole.ngc", shop / "lib/hole.ngc");
  const Interpreted result = shop.run(kCall, {"lib"});
  REQUIRE(result.diagnostics.size() == 1);
  CHECK(shows(render(result.diagnostics.front()),
              "softcnc:1:1: error: cannot call '" + (shop / "lib/hole.ngc") +
                  "': it is a link that leads out of '" + (shop / "lib") + "' [SC2317]"));
}

TEST_CASE("links that stay within a folder are followed, and so is one to the folder",
          "[ipr][search]") {
  Shop shop;
  std::filesystem::create_directory(shop / "lib/version_2");
  shop.with("lib/version_2/hole.ngc", sub("hole", 6));
  std::filesystem::create_symlink("version_2/hole.ngc", shop / "lib/hole.ngc");
  std::filesystem::create_directory_symlink("lib", shop / "link");
  CHECK(last_x(shop.run(kCall, {"lib"})) == 6);
  CHECK(last_x(shop.run(kCall, {"link"})) == 6);
  std::filesystem::create_symlink("nothing.ngc", shop / "lib/gone.ngc");
  CHECK(shows(rendered(shop.run("o<gone> call\nM2\n", {"lib"})), "[SC2301]"));
}

TEST_CASE("only regular files of the search path are read", "[ipr][search]") {
  Shop shop;
  std::filesystem::create_symlink("/dev/null", shop / "lib/hole.ngc");
  CHECK(shows(rendered(shop.run(kCall, {"lib"})), "[SC2317]"));
  std::filesystem::create_directory(shop / "more/hole.ngc");
  CHECK(shows(rendered(shop.run(kCall, {"more"})), "Is a directory [SC6031]"));
}

TEST_CASE("called files and those that are not there are known by their paths", "[ipr][search]") {
  Shop shop;
  CalledTexts called;
  shop.called = &called;
  shop.with("part/a.ngc", sub("a", 1)).with("more/hole.ngc", sub("hole", 2));
  InterpreterOptions options;
  options.folder = shop / "part";
  options.subprogram_folders = {shop / "lib", shop / "more"};
  options.called = &called;
  Reader reader = Reader::from_text("o<a> call\no<hole> call\nM2\n");
  Diagnostics diagnostics;
  Parser parser(reader, diagnostics);
  const Machine machine;
  Interpreter interpreter(parser, machine, diagnostics, options);
  while (interpreter.next()) {
  }
  const std::vector<FoundFile> files = interpreter.called_files();
  REQUIRE(files.size() == 2);
  CHECK(files[0].name == "a.ngc");
  CHECK(files[0].path == shop / "part/a.ngc");
  CHECK(files[1].name == "2/hole.ngc");
  CHECK(files[1].path == shop / "more/hole.ngc");
  CHECK(interpreter.missing_files().contains(shop / "lib/hole.ngc"));
  CHECK(interpreter.missing_files().contains(shop / "part/hole.ngc"));
}

}  // namespace softcnc::ipr
