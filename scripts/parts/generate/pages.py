# SPDX-License-Identifier: MIT
"""What generators of pages share: texts in sources of C++, tables of pages, and writing or comparing."""
import re
import sys

LITERAL = r'"(?:[^"\\]|\\.)*"'
TEXT = rf"((?:{LITERAL}\s*)+)"  # as in C++, literals that follow one another are one text


def text_of(literals):
    """The text of C++ string literals."""
    return "".join(literal[1:-1].replace('\\"', '"') for literal in re.findall(LITERAL, literals))


def with_table(page, head, table):
    """The text of a page with the table that begins with this head replaced, up to the next blank line."""
    text = page.read_text(encoding="utf-8")
    begin = text.index(head)
    return text[:begin] + table + text[text.index("\n\n", begin) + 1:]


def write_or_check(page, made, check, name):
    """Writes a page; with check changes nothing, and exits with 1 if the page is another one."""
    if page.exists() and page.read_text(encoding="utf-8") == made:
        return
    if check:
        sys.exit(f"{page} is not up to date; run scripts/generate {name}")
    page.write_text(made, encoding="utf-8")
    print(f"wrote {page}")
