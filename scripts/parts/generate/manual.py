#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes the man page, and what completes command lines in bash, zsh and fish, from what softcnc prints.

    scripts/generate manual FOLDER [SOFTCNC]

Writes softcnc.1, softcnc.bash, _softcnc and softcnc.fish into FOLDER. Commands and options are those of
--help, the words of a list those that softcnc names when it refuses another one, the keys of --set those
of `softcnc machine`, and the exit statuses those of docs/cli.md. SOFTCNC is the program that is asked, by
default that of build/release.
"""
import pathlib
import re
import subprocess
import sys

from options import PAGE, ROOT, commands_of, help_of, of, rows_of

PROGRAMS = "/usr/share/softcnc/programs"  # where the package puts them
EXAMPLES = {
    "Run a program on the simulated mill": f"softcnc run {PROGRAMS}/08_butterfly.nc",
    "Show where it is slow, and why, on a page": f"softcnc report {PROGRAMS}/08_butterfly.nc -o page.html",
    "Check all programs of a folder": f"softcnc check {PROGRAMS}",
}
HELP, VERSION = ("-h,--help", "Show this help"), ("-V,--version", "Show the version")


class Option:
    """An option of some commands: its names, its value, and the words that the value may be."""

    def __init__(self, softcnc, row, commands):
        shown, self.meaning = row
        names, _, self.value = shown.partition(" ")
        self.names, self.commands = names.split(","), commands
        self.is_list = self.value.startswith("NAME") and "=" not in self.value
        self.words = self.value.split("|") if "|" in self.value else []
        if self.is_list:
            refused = asked(softcnc, commands[0], self.names[-1], "?", "--help")
            self.words = re.search(r"is not one of (.*)", refused)[1].split(", ")
        if self.value == "KEY=VALUE":
            self.words = settings(softcnc)
        self.is_folder = self.value == "DIR"
        self.is_file = self.value.startswith("FILE") or self.value == "B"


def asked(softcnc, *words):
    """What softcnc prints of these words, errors included."""
    return subprocess.run([softcnc, *words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True).stdout


def settings(softcnc):
    """KEY= for each key of the built-in machine, or KEY=WORD for each word of one that takes words."""
    keys = [line.split()[0] for line in asked(softcnc, "machine").splitlines()]
    wrong = asked(softcnc, "machine", *(word for key in keys for word in ("--set", f"{key}=?")))
    words = {key: re.findall("'([^']*)'", known)
             for key, known in re.findall(r"error: (\S+) must be one of (.*), not '\?'", wrong)}
    return [f"{key}={word}" for key in keys for word in words.get(key, [""])]


def commands_with_meaning(softcnc):
    text = help_of(softcnc)
    return {name: re.search(rf"^  {name} +(.*)", text, re.MULTILINE)[1] for name in commands_of(softcnc)}


def roff(text):
    """A text as troff takes it."""
    text = text.replace("\\", r"\e").replace("-", r"\-").replace("'", r"\(aq")
    return r"\&" + text if text.startswith(".") else text


def man_page(softcnc, commands, options):
    version = asked(softcnc, "--version").split()[1]
    lines = [r'.\" Made by scripts/generate manual.', f'.TH SOFTCNC 1 "" "softcnc {version}" "User Commands"',
             ".SH NAME", r"softcnc \- read, plan, check and run part programs of machine tools",
             ".SH SYNOPSIS", ".B softcnc", r"\fICOMMAND\fR [\fIOPTION\fR...] [\fIFILE\fR...]",
             ".SH DESCRIPTION", roff(help_of(softcnc).splitlines()[0]),
             "It computes how fast a machine may follow a part program within all of its limits.",
             ".SH COMMANDS"]
    for name, meaning in commands.items():
        words = re.search(rf"^Usage: softcnc {name} (.*)", help_of(softcnc, name), re.MULTILINE)[1]
        words = re.sub(r"\(\dx\)", "...", words)
        lines += [".TP", rf"\fB{name}\fR {roff(words)}", roff(meaning) + "."]
    lines += [".SH OPTIONS"]
    for option in options:
        names = ", ".join(rf"\fB{roff(name)}\fR" for name in option.names)
        value = rf" \fI{roff(option.value)}\fR" if option.value else ""
        lines += [".TP", names + value, roff(option.meaning) + ".",
                  f"Commands: {of(option.commands, list(commands))}."]
    for names, meaning in (HELP, VERSION):
        lines += [".TP", ", ".join(rf"\fB{roff(name)}\fR" for name in names.split(",")), meaning + "."]
    lines += [".SH EXIT STATUS"]
    statuses = PAGE.read_text(encoding="utf-8").split("\n## Exit status\n")[1].split("\n\n")[1]
    for status, meaning in re.findall(r"^\| ([^|-]+) \| ([^|]+) \|$", statuses, re.MULTILINE):
        lines += [".TP", roff(status), roff(meaning.replace("`", "")) + "."]
    lines += [".SH EXAMPLES"]
    for meaning, line in EXAMPLES.items():
        lines += [".TP", meaning, rf"\fB{roff(line)}\fR"]
    return "\n".join(lines) + "\n"


BASH = """\
# Completes command lines of softcnc in bash. Made by scripts/generate manual.
_softcnc() {
  local line=${COMP_LINE:0:COMP_POINT} words word current previous command='' offered='' list='' before=''
  read -ra words <<<"$line"
  [[ $line != *[[:space:]] ]] || words+=('')
  current=${words[-1]} previous=${words[-2]}
  for word in "${words[@]:1:${#words[@]}-2}"; do
    [[ $word == -* ]] || { command=$word; break; }
  done
  [[ $current != --*=* ]] || { previous=${current%%=*} current=${current#*=}; }
  case "$command $previous" in
%s  esac
  if [[ -z $offered && $current == -* ]]; then
    case $command in
%s    esac
  fi
  case $command in
    '' | help) offered=${offered:-%s help} ;;
  esac
  [[ -z $list || $current != *,* ]] || before=${current%%,*},
  mapfile -t COMPREPLY < <(compgen -P "$before" -W "$offered" -- "${current#"$before"}")
  [[ ${COMPREPLY[0]} != *= ]] || compopt -o nospace 2>/dev/null
  [[ $current != *=* || $COMP_WORDBREAKS != *=* ]] || COMPREPLY=("${COMPREPLY[@]#"${current%%=*}="}")
}
complete -o default -F _softcnc softcnc
"""


def bash(commands, options):
    cases = "".join(
        f"    {' | '.join(quoted(f'{command} {name}') for command in option.commands for name in option.names)})\n"
        f"      {'list=yes ' if option.is_list else ''}offered={quoted(' '.join(option.words))} ;;\n"
        for option in options if option.words)
    names = {command: [name for option in options if command in option.commands for name in option.names]
             for command in commands}
    named = "".join(f"      {command}) offered={quoted(' '.join([*names[command], *HELP[0].split(',')]))} ;;\n"
                    for command in commands)
    named += f"      '') offered={quoted(' '.join((HELP[0] + ',' + VERSION[0]).split(',')))} ;;\n"
    return BASH % (cases, named, " ".join(commands))


def quoted(text):
    """A text as a word of a shell."""
    return "'" + text.replace("'", "'\\''") + "'"


ZSH = """\
#compdef softcnc
# Completes command lines of softcnc in zsh. Made by scripts/generate manual.
_softcnc_settings() {
  compadd -S '' -- %s
}

_softcnc_commands() {
  local -a commands=(
%s  )
  _describe command commands
}

_softcnc() {
  local context state state_descr line
  typeset -A opt_args
  _arguments -C %s %s '1:command:_softcnc_commands' '*::argument:->argument'
  [[ $state == argument ]] || return
  case $words[1] in
    help) _softcnc_commands ;;
%s  esac
}

_softcnc "$@"
"""


def zsh_value(option):
    if option.value == "KEY=VALUE":
        return ":KEY=VALUE:_softcnc_settings"
    if option.is_list:
        return f":name:_sequence compadd - {' '.join(option.words)}"
    if option.words:
        return f":word:({' '.join(option.words)})"
    return ":folder:_files -/" if option.is_folder else ":file:_files" if option.is_file else ":value: "


def zsh_option(names, meaning, value="", repeats=False):
    text = "[" + re.sub(r"([\[\]\\])", r"\\\1", meaning) + "]" + value
    if repeats:
        return quoted("*" + names[0] + ("=" if value else "") + text)
    spelled = [name + (("=" if name.startswith("--") else "+") if value else "") for name in names]
    if len(names) == 1:
        return quoted(spelled[0] + text)
    return quoted(f"({' '.join(names)})") + "{" + ",".join(spelled) + "}" + quoted(text)


def zsh(commands, options):
    described = "".join(f"    {quoted(f'{name}:{meaning}')}\n" for name, meaning in commands.items())
    common = [zsh_option(names.split(","), meaning) for names, meaning in (HELP, VERSION)]
    cases = ""
    for command in commands:
        specs = [zsh_option(option.names, option.meaning, zsh_value(option) if option.value else "",
                            "repeatable" in option.meaning) for option in options if command in option.commands]
        cases += f"    {command})\n      _arguments \\\n"
        cases += "".join(f"        {spec} \\\n" for spec in [*specs, common[0]]) + "        '*:file:_files' ;;\n"
    keys = next(option.words for option in options if option.value == "KEY=VALUE")
    return ZSH % (" ".join(keys), described, *common, cases)


def fish(commands, options):
    def text(words):
        return "'" + words.replace("\\", r"\\").replace("'", r"\'") + "'"

    def line(condition, rest, meaning):
        return f"complete -c softcnc -n {text(condition)} {rest} -d {text(meaning)}\n"

    lines = "# Completes command lines of softcnc in fish. Made by scripts/generate manual.\n"
    lines += "complete -c softcnc -n '__fish_is_nth_token 1' -f\n"
    for name, meaning in commands.items():
        lines += line("__fish_is_nth_token 1; or __fish_seen_subcommand_from help", f"-a {name}", meaning)
    lines += line("__fish_is_nth_token 1", "-a help", "List the options of a command")
    for option in options:
        flags = " ".join(f"-l {name[2:]}" if name.startswith("--") else f"-s {name[1:]}" for name in option.names)
        words = " ".join(option.words)
        if option.words:
            flags += " -x -a " + text(f"(__fish_append , {words})" if option.is_list else words)
        elif option.value:
            flags += (" -r -F" if option.is_file else " -x -a '(__fish_complete_directories)'"
                      if option.is_folder else " -x")
        lines += line("__fish_seen_subcommand_from " + " ".join(option.commands), flags, option.meaning)
    lines += "complete -c softcnc -s h -l help -d " + text(HELP[1]) + "\n"
    return lines + line("__fish_is_nth_token 1", "-s V -l version", VERSION[1])


def main(arguments):
    if not 1 <= len(arguments) <= 2 or arguments[0].startswith("-"):
        sys.exit(__doc__)
    folder = pathlib.Path(arguments[0])
    softcnc = arguments[1] if len(arguments) > 1 else ROOT / "build/release/apps/softcnc/softcnc"
    commands = commands_with_meaning(softcnc)
    options = [Option(softcnc, row, takes) for row, takes in rows_of(softcnc).items()]
    folder.mkdir(parents=True, exist_ok=True)
    for name, text in {"softcnc.1": man_page(softcnc, commands, options), "softcnc.bash": bash(commands, options),
                       "_softcnc": zsh(commands, options), "softcnc.fish": fish(commands, options)}.items():
        (folder / name).write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1:])
