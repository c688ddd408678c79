#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks the man page, and what completes command lines, against softcnc itself.

    tests/apps/manual_test.py SOFTCNC [ROOT]

Makes them first, or takes those that a package has installed below ROOT. The page must name each command
and each option of --help. Bash must offer them where they may stand, and the words of options that
take words: by its own line editor, on a terminal. zsh and fish must read their files, and fish must
offer the same; without these shells they are left out. Then options are removed from the files, which
must be noticed.
"""
import gzip
import os
import pathlib
import pty
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
INSTALLED = {"softcnc.1": "man/man1/softcnc.1.gz", "softcnc.bash": "bash-completion/completions/softcnc",
             "_softcnc": "zsh/vendor-completions/_softcnc", "softcnc.fish": "fish/vendor_completions.d/softcnc.fish"}
# Command lines, and words that must be offered after them: methods, dialects, keys and their values.
OFFERED = {
    "run --dialect ": ["linuxcnc", "fanuc", "haas", "grbl", "auto"],
    "run --set control.": ["control.period_ms=", "control.interpolation=taylor2", "control.backend=sim"],
    "check --set axis.x.vel": ["axis.x.velocity_mm_min="],
    "compare --methods ": ["all", "arc-length", "dda", "rk4"],
    "compare --methods rk4,arc": ["rk4,arc-length"],
    "report --plot path,f": ["path,feed"],
    "run --columns rmax": ["rmax_um"],
    "help conv": ["convert"],
}


def help_of(softcnc, *command):
    return subprocess.run([softcnc, *command, "--help"], check=True, capture_output=True, text=True).stdout


def known_to(softcnc):
    """The options of each command, and of none (""), by --help."""
    commands = re.findall(r"^  ([a-z]+) {3,}", help_of(softcnc).split("Commands:")[1], re.MULTILINE)
    assert len(commands) > 10
    return {command: set(re.findall(r"(?:^  |(?<=,))(--?[A-Za-z][a-z-]*)", help_of(softcnc, *command.split()),
                                    re.MULTILINE))
            for command in ["", *commands]}


def lines_to_offer(known):
    """Command lines, and what must be offered after each."""
    lines = {f"{command} -".lstrip(): sorted(options) for command, options in known.items()}
    return {**lines, "": sorted(command for command in known if command), **OFFERED}


def offered_by_bash(file, lines):
    """What bash inserts for each line when all completions are asked for, which M-* does."""
    child, terminal = pty.fork()
    if child == 0:
        os.environ.update(PS1="", TERM="dumb", INPUTRC="/dev/null", COLUMNS="30000")
        os.execvp("bash", ["bash", "--norc", "--noprofile", "-i"])
    os.write(terminal, f". {file}; softcnc() {{ printf 'offered: %s\\n' \"$*\"; }}\n".encode())
    shown = b""
    for count, line in enumerate(lines, 1):  # one by one: a terminal holds few bytes
        os.write(terminal, f"softcnc {line}\x1b*\n".encode())
        while shown.count(b"\noffered: ") < count:
            shown += os.read(terminal, 65536)
    os.write(terminal, b"exit\n")
    os.close(terminal)
    os.waitpid(child, 0)
    return [found.split() for found in re.findall(r"^offered: (.*?)\r?$", shown.decode(), re.MULTILINE)]


def faults_of_bash(file, lines):
    for (line, wanted), offered in zip(lines.items(), offered_by_bash(file, lines), strict=True):
        for word in set(wanted) - set(offered):
            yield f"bash does not offer {word} after 'softcnc {line}'"


def faults_of_fish(file, lines):
    for line, wanted in lines.items():
        script = f"source {file}; complete -C {repr('softcnc ' + line)}"
        offered = subprocess.run(["fish", "--no-config", "-c", script], check=True, capture_output=True, text=True)
        found = {row.split("\t")[0] for row in offered.stdout.splitlines()}
        for word in set(wanted) - found:
            yield f"fish does not offer {word} after 'softcnc {line}'"


def faults_of_page(page, known):
    page = page.replace(r"\-", "-")
    for word in set(known).union(*known.values()) - {""}:
        if rf"\fB{word}\fR" not in page:
            yield f"the man page does not name {word}"


def faults_of_zsh(text, known):
    """Those of a text: what zsh makes of it is for its own line editor, which has no list of words."""
    for command in known:
        part = text.split(f"    {command})\n")[-1].split(";;")[0] if command else text.split("_arguments -C")[1]
        for word in known[command]:
            if not re.search(rf"(?<![\w-]){word}(?![\w-])", part):
                yield f"_softcnc does not name {word} of '{command}'"


def faults(files, known):
    page = files["softcnc.1"]
    text = gzip.decompress(page.read_bytes()).decode() if page.suffix == ".gz" else page.read_text()
    yield from faults_of_page(text, known)
    lines = lines_to_offer(known)
    yield from faults_of_bash(files["softcnc.bash"], lines)
    yield from faults_of_zsh(files["_softcnc"].read_text(), known)
    for shell, name in (("zsh", "_softcnc"), ("fish", "softcnc.fish")):
        if shutil.which(shell):
            read = subprocess.run([shell, "-n", files[name]], capture_output=True, text=True)
            if read.returncode:
                yield f"{shell} cannot read {name}: {read.stderr}"
    if shutil.which("fish"):
        yield from faults_of_fish(files["softcnc.fish"], lines)


def altered_are_found(files, known, folder):
    """Whether each file is faulty without an option."""
    for name in files if shutil.which("fish") else [name for name in files if name != "softcnc.fish"]:
        for option in ("dialect", "methods"):
            altered = {key: folder / f"altered_{key}" for key in files}
            for key, file in files.items():
                text = file.read_text()
                altered[key].write_text(text.replace(option, "x") if key == name else text)
            if not any(faults(altered, known)):
                yield f"nobody notices that {name} has no --{option}"


def main(softcnc, root=None):
    known = known_to(softcnc)
    if root:
        share = pathlib.Path(root) / "usr/share"
        wrong = list(faults({name: share / place for name, place in INSTALLED.items()}, known))
    else:
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            subprocess.run([ROOT / "scripts/parts/generate/manual.py", folder, softcnc], check=True)
            files = {made: folder / made for made in INSTALLED}
            wrong = list(faults(files, known)) or list(altered_are_found(files, known, folder))
    print(*wrong, sep="\n")
    return 1 if wrong else 0


if __name__ == "__main__":
    if not 2 <= len(sys.argv) <= 3:
        sys.exit(__doc__)
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve(), *sys.argv[2:]))
