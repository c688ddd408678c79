#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs the command lines that README.md, CONTRIBUTING.md and docs/*.md show.

    tests/apps/documented_commands.py SOFTCNC [PAGE...]

A command line is a line of a block of code, or code within a text, that begins with one of WORDS.
Each page has a folder of its own with a copy of programs/, in which its lines run in their order;
each must end with status 0. A block of code with the name of a file behind its language (```toml
part.toml) is that file. LEFT_OUT lists what is not run, with the reason; a reason that no page
needs is an error, too.
"""
import collections
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
PAGES = ["README.md", "CONTRIBUTING.md", *sorted(f"docs/{p.name}" for p in (ROOT / "docs").glob("*.md"))]
WORDS = r"softcnc|scripts/\w+(?:\.py)?|tests/\S+\.py|build/\S+|halrun|halstreamer|mkfifo|awk|grep|ROWS=\S+"
LEAST = 40  # command lines on all pages; fewer means that they are not found
SECONDS = 120

BUILDS = "installs packages and builds"
MEASURES = "builds, and measures for minutes to hours"
OPERATES = "needs a person at a terminal; tests/apps/operate_session.py is one"
SERVES = "serves until it is ended; tests/apps/serve_clients.py connects to it"
LEFT_OUT = {
    "softcnc serve": SERVES,
    "softcnc serve [PART]": SERVES,
    "softcnc serve --pty grbl": SERVES,
    "softcnc serve --pty grbl --state mill.state.toml": SERVES,
    "softcnc serve part.nc --pty grbl": SERVES,
    "softcnc operate": OPERATES,
    "softcnc operate [PART]": OPERATES,
    "softcnc operate PART --state mill.toml": OPERATES,
    "softcnc operate programs/31_first_part.nc --state mill.state.toml": OPERATES,
    "scripts/run programs/08_butterfly.nc": BUILDS + "; the same with softcnc run is run",
    "scripts/test": BUILDS + "; it runs this",
    "scripts/test --all": BUILDS + "; it runs this",
    "scripts/check package": BUILDS + "; scripts/test runs it",
    "scripts/package": BUILDS + "; scripts/check deb runs it",
    "scripts/check deb": BUILDS + ", and installs in a bare Debian; scripts/test --all runs it",
    "scripts/generate manual": "writes files that tests/apps/manual_test.py makes and checks",
    "scripts/generate golden": BUILDS + ", and replaces what the tests compare with",
    "scripts/generate programs": "writes into the sources; a test of its own runs it with --check",
    "scripts/generate codes": "writes into the sources; a test of its own runs it with --check",
    "scripts/generate code_table": "writes into the sources; a test of its own runs it with --check",
    "scripts/generate options": "writes into the sources; a test of its own runs it with --check",
    "scripts/generate page": BUILDS + ", with Node, and writes into the sources; scripts/test runs it with --check",
    "scripts/generate pictures": BUILDS + ", and writes into the sources",
    "scripts/check": "checks the sources, which are not in the folder of a page",
    "scripts/check --help": "is not in the folder of a page",
    "scripts/generate --check": "checks the sources; a test of its own runs each part of it",
    "scripts/generate --help": "is not in the folder of a page",
    "scripts/generate": "lists its names",
    "scripts/stress": "lists its names",
    "scripts/bench": "lists its names",
    "scripts/check tidy": BUILDS,
    "scripts/check coverage": BUILDS,
    "scripts/check page": BUILDS + ", with Node; scripts/test runs it",
    "scripts/stress fuzz SECONDS": BUILDS + "; scripts/test runs it",
    "scripts/stress fuzz --runs N": BUILDS + "; scripts/test runs it",
    "scripts/stress faults": BUILDS + "; a test of its own runs some of it",
    "scripts/check builds": "needs two builds",
    "scripts/generate feed": MEASURES,
    "scripts/generate feed --check": MEASURES,
    "scripts/generate feed --write": MEASURES,
    "scripts/bench planning": MEASURES,
    "scripts/generate pulses": MEASURES,
    "scripts/generate surface": MEASURES,
    "scripts/generate roughness": MEASURES,
    "scripts/generate roughness_map": MEASURES,
    "scripts/generate roughness_map rmax": MEASURES,
    "scripts/generate roughness_map critical feed_from=0.5 feed_step=0.01": MEASURES,
    "scripts/generate roughness_map rmax radius=3 pick=0.2 grid_um=1 feed_to=1.5": MEASURES,
    "scripts/figures": MEASURES,
    "scripts/figures 004": MEASURES,
    "scripts/figures --check": MEASURES + "; a test of its own runs it",
    "scripts/figures --draw": "writes into the sources",
    "scripts/generate airfoil": "writes into the sources; a test of its own runs it with --check",
    "softcnc surface plane.nc --machine programs/21_paper004_surface.toml --set stock.origin_mm=[7,0.5,-1]"
    " --set stock.x_mm=2 --set stock.y_mm=2 --set stock.z_mm=8 --set stock.grid_um=2.5 -o plane.npz --report plane.json": "runs the program above it; scripts/figures does",
    "tests/oracle/papers_test.py": "is a test of its own",
    "tests/apps/ci_recipes.py": "is a test of its own",
    "scripts/stress pulses": MEASURES,
    "scripts/stress pulses [COUNT]": MEASURES,
    "scripts/stress programs": MEASURES,
    "scripts/stress mistakes": MEASURES,
    "scripts/check rs274": "installs linuxcnc-uspace",
    "scripts/check hal": "installs linuxcnc-uspace",
    "scripts/check parport": "boots another kernel in an emulator",
    "scripts/check cncjs": "installs CNCjs from npm",
    "tests/apps/documented_commands.py": "is this one",
    "tests/oracle/check_trace.py": "is part of another test",
    "tests/oracle/mixed_paths.py": "is part of another test",
    "tests/oracle/programmed_path.py": "is part of another test",
    "tests/oracle/time_optimal.py": "is part of another test",
    "ROWS=rows halrun -I -f programs/hal/mill.hal": "needs linuxcnc-uspace; scripts/check hal runs it",
    "halstreamer < trace.hal": "needs linuxcnc-uspace",
    "halstreamer": "needs linuxcnc-uspace",
    "grep -v '^#' FILE | xxhsum -H2": "needs the package xxhash",
}
# Scripts whose first word is a name that they list with --help.
LISTS_NAMES = ("scripts/generate", "scripts/stress", "scripts/check", "scripts/bench")

# Lines with a placeholder, as shown, and the lines that are run for them.
STANDS_FOR = {
    "softcnc check PART...": "softcnc check programs/01_line.nc programs/02_square.nc",
    "softcnc replay F.rec...": "softcnc replay F.rec",
    "softcnc diff A B": "softcnc diff n.rec programs/01_line.nc",
    "softcnc circle FILE": "softcnc circle ball_bar.csv",
    "softcnc identify TRACE": "softcnc identify t.npz",
    "softcnc replay FOLDER": "softcnc replay .",
    "softcnc pulses FILE": "softcnc pulses arc.vcd",
    "softcnc pulses FILE [--machine M.toml] [--backend parport]":
        "softcnc pulses arc.vcd --machine programs/machines/bench_mill.toml",
    "softcnc machine import FILE": "softcnc machine import programs/settings/router.txt",
    "softcnc codes [CODE...]": "softcnc codes G02 SC2103",
    "softcnc report RUN -o F.html": "softcnc report programs/03_arc.nc -o F.html",
    "softcnc report FILE -o PAGE.html": "softcnc report programs/03_arc.nc -o PAGE.html",
    "softcnc compare PART...": "softcnc compare programs/03_arc.nc --phases 2",
    "softcnc surface PART -o FILE": "softcnc surface programs/20_paper004_cylinder.nc -o part.png",
    "softcnc latency": "softcnc latency --seconds 0.1",
    "softcnc latency --seconds 10 --period-us 1000": "softcnc latency --seconds 0.1 --period-us 1000",
    "softcnc COMMAND --help": "softcnc run --help",
    "softcnc run --machine programs/hal/mill.toml PART":
        "cat rows >/dev/null & softcnc run --machine programs/hal/mill.toml programs/01_line.nc && wait",
}
# What a busy computer may report, by a word in the line.
BUSY = {"--realtime": "[SC504"}
EDGES = "softcnc run -q programs/03_arc.nc --backend stepdir --set backend.stepdir.file=arc.vcd"
BEFORE = {  # what a page requires
    "docs/cli.md": [EDGES, "softcnc record -q programs/01_line.nc -o n.rec",
                    "softcnc run -q --dry-run programs/03_arc.nc --trace before.csv.zst",
                    "softcnc run -q programs/27_ball_bar.nc --trace ball_bar.csv",
                    "softcnc run -q programs/26_identify.nc --trace t.npz"],
    "docs/backlash.md": ["printf '[axis.x]\\nbacklash_um = 100\\n[axis.y]\\n[axis.z]\\n' > worn.toml"],
    "docs/circle.md": ["printf '[axis.x]\\nbacklash_um = 100\\n[axis.y]\\n[axis.z]\\n' > worn.toml"],
    "docs/pulses.md": [EDGES],
    "docs/machine.md": ["cp programs/machines/bench_mill.toml mill.toml"],
    "docs/trace.md": ["softcnc run -q programs/03_arc.nc --trace trace.csv"],
}


def as_shown(line):
    """The command line of a line of code, without prompt, remark and explanation; None: it is none."""
    line = line.strip().removeprefix("$ ")
    if not re.match(rf"(?:{WORDS})(?:\s|$)", line):
        return None
    line = re.split(r"\s+# ", line)[0]
    return re.split(r"\s{2,}", line)[0] if line.startswith("softcnc") else line.strip()


def command_lines(text):
    """(number, command line) of a page, in its order."""
    fenced = False
    for number, line in enumerate(text.splitlines(), 1):
        if line.lstrip().startswith("```"):
            fenced = not fenced
        elif fenced or line.startswith("    "):
            if not re.match(r"\s*softcnc:", line) and (command := as_shown(line)):
                yield number, command
        else:
            for code in re.findall(r"`([^`]+)`", line):
                if code != "softcnc" and (command := as_shown(code.replace(r"\|", "|"))):
                    yield number, command


def as_run(command):
    """The line that is run for the one that is shown."""
    if command in STANDS_FOR:
        return STANDS_FOR[command]
    if re.fullmatch(r"softcnc (run|check|blocks|record|replay|diff|surface|compare|pulses)", command):
        return command + " --help"  # a name in a text
    surface = command.startswith("softcnc surface")
    return command.replace("PART", "programs/" + ("20_paper004_cylinder.nc" if surface else "03_arc.nc"))


def run(command, folder, softcnc):
    """What is wrong with a command line, as a text; None if nothing is."""
    path = f"{softcnc.parent}{os.pathsep}{os.environ['PATH']}"
    try:
        ended = subprocess.run(["bash", "-c", command], cwd=folder, stdin=subprocess.DEVNULL,
                               env={**os.environ, "PATH": path}, timeout=SECONDS,
                               stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    except subprocess.TimeoutExpired:
        return f"takes more than {SECONDS} s"
    shown = ended.stdout.decode(errors="replace")
    if ended.returncode == 0 or any(word in command and text in shown for word, text in BUSY.items()):
        return None
    return f"status {ended.returncode}\n{shown[-1000:]}"


def exists(command):
    """Whether a script is there and, where it takes the name of a part, lists that name."""
    script, *words = command.split()
    if not script.startswith(("scripts/", "tests/")):
        return True
    if not (ROOT / script).exists():
        return False
    if script not in LISTS_NAMES or not words or words[0].startswith("-"):
        return True
    listed = subprocess.run([ROOT / script, "--help"], check=True, capture_output=True, text=True).stdout
    return re.search(rf"^  {re.escape(words[0])} ", listed, re.MULTILINE) is not None


def try_page(page, text, softcnc):
    """The faults of a page, and the number of its command lines that were run."""
    faults, count = [], 0
    with tempfile.TemporaryDirectory() as folder:
        shutil.copytree(ROOT / "programs", pathlib.Path(folder) / "programs")
        for command in BEFORE.get(page, []):
            assert not run(command, folder, softcnc), command
        for name, content in re.findall(r"^```\w+ (\S+)\n(.*?)^```$", text, re.MULTILINE | re.DOTALL):
            (pathlib.Path(folder) / name).write_text(content)
        for number, command in command_lines(text):
            if command in LEFT_OUT:
                if not exists(command):
                    faults.append(f"{page}:{number}: {command}: there is no such script, or no such name")
                continue
            count += 1
            if fault := run(as_run(command), folder, softcnc):
                faults.append(f"{page}:{number}: {command}: {fault}")
    return faults, count


def finds_faults(softcnc):
    """Whether the faults of a wrong page are found."""
    page = "Text with `softcnc run no.nc`.\n\n```\n$ softcnc chekc programs/*.nc   # what is wrong\n```\n\n" \
           "    softcnc machine --machine no.toml\n    softcnc machine\n"
    faults, count = try_page("page", page, softcnc)
    return count == 4 and [fault.split(": ")[0] for fault in faults] == ["page:1", "page:4", "page:7"]


def main():
    softcnc, only = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2:]
    faults, counts = [], collections.Counter()
    if not finds_faults(softcnc):
        faults.append("wrong command lines of a page made up for this are not found")
    texts = {page: (ROOT / page).read_text() for page in only or PAGES}
    for page, text in texts.items():
        wrong, counts[page] = try_page(page, text, softcnc)
        faults += wrong
    shown = {command for text in texts.values() for _, command in command_lines(text)}
    if not only:
        faults += [f"{command} is left out, but no page shows it" for command in LEFT_OUT.keys() - shown]
        if counts.total() < LEAST:
            faults.append(f"only {counts.total()} command lines are found")
    print(*(f"{count:3} {page}" for page, count in counts.items() if count), sep="\n")
    print(f"{counts.total()} command lines run, {len(shown & LEFT_OUT.keys())} left out, {len(faults)} faults")
    print(*faults, sep="\n", end="")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
