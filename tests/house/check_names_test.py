#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What scripts/check names finds in sources that are made for it, and what it leaves alone."""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPT = Path(sys.argv.pop(1))


class CheckNames(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def write(self, path, text):
        file = Path(self.folder.name) / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")

    def found(self, *paths):
        run = subprocess.run([SCRIPT, "--root", self.folder.name, *paths], capture_output=True,
                             text=True, check=False)
        self.assertEqual(run.returncode, 1 if run.stdout else 0, run.stderr)
        return run.stdout.splitlines()

    def test_sources_in_the_words_of_the_field_pass(self):
        self.write("libs/ipo/limits.hpp", "namespace a { struct Limit { double velocity_limit() const; };"
                   " struct Other { struct Place {}; }; }")
        self.write("libs/hal/port.cpp", "namespace a { struct Place {}; // a bend of the way\n"
                   "int rows() { const int cap = 1; return cap; } }")
        self.assertEqual(self.found(), [])

    def test_a_type_that_two_sources_define_is_found(self):
        self.write("libs/ipo/one.hpp", "namespace a { class Place final : public Base { int x; }; }")
        self.write("libs/hal/two.cpp", "namespace a { namespace { enum class Place { here }; } }")
        self.write("libs/hal/three.cpp", "namespace a { using Place = int; }")
        self.assertEqual(self.found(), ["libs/hal/three.cpp: type Place is also one of "
                                        "libs/hal/two.cpp, libs/ipo/one.hpp"])

    def test_words_that_the_glossary_replaces_are_found(self):
        self.write("libs/ipo/mesh.hpp", "namespace a { struct KinkLoad { double at_cap(double v) const; };"
                   " template <typename T> T longest_way(const T& rows); }")
        self.write("apps/softcnc/run.cpp", "namespace a { void tell_rows() {} }")
        self.assertEqual(self.found(), [
            "apps/softcnc/run.cpp: function tell_rows: the field says report, not tell",
            "libs/ipo/mesh.hpp: file mesh: the field says knot vector, not mesh",
            "libs/ipo/mesh.hpp: function at_cap: the field says velocity limit, not cap",
            "libs/ipo/mesh.hpp: function longest_way: the field says distance, path length, not way",
            "libs/ipo/mesh.hpp: type KinkLoad: the field says tangent jump, corner, not kink"])
        self.assertEqual(len(self.found("apps")), 1)

    def test_constants_are_checked_too_and_passed_only_where_lines_are_skipped(self):
        text = "namespace a { constexpr int kBehindSign{1}; struct Passed {}; int faults(); }"
        self.write("libs/ipr/one.cpp", text)
        self.write("libs/ipo/two.cpp", text.replace("kBehindSign", "kAfterSign"))
        self.assertEqual([line.split(": ")[1] for line in self.found("libs/ipr")],
                         ["constant kBehindSign", "function faults", "type Passed"])
        self.assertEqual(len([line for line in self.found() if "passed" in line]), 1)

    def test_rows_are_samples_or_constraints_where_motion_is_planned(self):
        text = "namespace a { struct SpeedRow {}; }"
        self.write("libs/ipo/speed.hpp", text)
        self.write("libs/hal/trace.hpp", text.replace("Speed", "Trace"))
        self.assertEqual(self.found(), ["libs/ipo/speed.hpp: type SpeedRow: the field says sample, "
                                        "constraint, not row"])

    def test_a_folder_of_26_units_is_found(self):
        for i in range(25):
            self.write(f"libs/ipo/unit_{i}.hpp", "")
            self.write(f"libs/ipo/unit_{i}.cpp", "")
        self.assertEqual(self.found(), [])
        self.write("libs/ipo/unit_25.cpp", "")
        self.assertEqual(self.found(), ["libs/ipo: 26 units, more than 25"])


if __name__ == "__main__":
    unittest.main()
