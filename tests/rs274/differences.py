# SPDX-License-Identifier: MIT
"""The deliberate differences from LinuxCNC: the table of docs/differences.md, read by what its last column says.

    refused SC1001 /X1E5/     LinuxCNC accepts the program, softcnc reports this code on a line that holds the pattern
    accepted "Nested" /\\(/    LinuxCNC refuses the program with this text, the line that holds the pattern; softcnc does not
    moves "feed" /G18.*G2/    they move otherwise, in what the text says; the program holds the pattern in a line up to there

Text and pattern may be left out.
"""
import re
from dataclasses import dataclass

SIGN = re.compile(r'^`(refused|accepted|moves)(?: (SC\d+))?(?: "([^"]*)")?(?: /(.*)/)?`$')


@dataclass(frozen=True)
class Finding:
    kind: str     # refused, accepted, moves
    program: str
    code: str     # softcnc's
    text: str     # of the error, or in what the moves differ
    line: str     # of the program
    before: str = ""  # the program up to that line, where the pattern may lie in any line of it

    def __str__(self):
        return f"{self.program}: {self.kind} {self.code} {self.text}\n    {self.line}"


@dataclass
class Difference:
    what: str
    kind: str
    code: str
    text: str
    pattern: str
    seen: int = 0

    def explains(self, finding):
        return (self.kind == finding.kind and (not self.code or self.code == finding.code)
                and (not self.text or self.text in finding.text)
                and bool(re.search(self.pattern, finding.before or finding.line, re.IGNORECASE)))


def read(path):
    """The rows of the table whose header ends in `found as`."""
    rows = []
    for line in path.read_text(encoding="utf-8").splitlines():
        cells = [cell.strip().replace("\\|", "|") for cell in re.split(r"(?<!\\)\|", line)[1:-1]]
        for sign in re.split(r"<br>", cells[-1]) if cells else []:
            found = SIGN.match(sign.strip())
            if found:
                kind, code, text, pattern = found.groups()
                rows.append(Difference(cells[0], kind, code or "", text or "", pattern or ""))
    return rows


def explanation(finding, differences):
    """The first row that explains it, or None."""
    return next((row for row in differences if row.explains(finding)), None)
