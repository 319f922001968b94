"""The tutorials do what they say: their commands run, one after the other in one folder, and print what stands behind them.

A block of `sh` is run; the block of `text` after it is what it prints, in which a line `…` stands for any number of lines, and times that a command took are left out. A block of
`python` or `toml` whose first line is a comment with a file's name is that file. `UPDATE_GOLDEN=1` writes what was printed into the pages (where a block has no `…`).
"""

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from conftest import ROOT
from test_readme import FLEXAIR

PAGES = sorted((ROOT / "docs" / "tutorial").glob("*.md"))
ELISION = "…"


def run(commands, folder):
    """What the commands of a block print on both channels; they must succeed."""
    tools = folder / "tools"
    tools.mkdir(exist_ok=True)
    for name, command in (("flexair", FLEXAIR), ("python", [sys.executable])):
        script = tools / name
        words = " ".join(f"'{word}'" for word in command)
        script.write_text(f'#!/bin/sh\nexec {words} "$@"\n')
        script.chmod(0o755)
    environment = os.environ | {"PATH": f"{tools}{os.pathsep}{os.environ['PATH']}"}
    found = subprocess.run(
        ["bash", "-euo", "pipefail", "-c", commands],
        cwd=folder,
        env=environment,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    )
    assert found.returncode == 0, f"{commands}\n{found.stdout}"
    return re.sub(r"(found|flown) in [\d.]+ s\b( on \d+ cores?)?", rf"\1 in {ELISION} s", found.stdout)


def matches(expected, printed):
    parts = [re.escape(part) for part in re.split(rf"^{ELISION}\n", expected, flags=re.MULTILINE)]
    return re.fullmatch("(?:.*\n)*?".join(parts), printed) is not None


@pytest.mark.skipif(sys.platform != "linux", reason="the commands are those for Linux")
@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_commands_print_what_the_tutorial_says(page, tmp_path):
    (tmp_path / "examples").symlink_to(ROOT / "examples")
    text = page.read_text(encoding="utf-8")
    differing, new, printed = [], [], None
    for part in re.split(r"(^```\w+\n.*?^```\n)", text, flags=re.DOTALL | re.MULTILINE):
        block = re.fullmatch(r"```(\w+)\n(.*?)```\n", part, re.DOTALL)
        language, content = block.groups() if block else (None, None)
        file = re.match(r"# (\S+\.\w+)\n", content or "")
        if language in ("python", "toml") and file:
            (tmp_path / file[1]).write_text(content, encoding="utf-8")
        elif language == "sh":
            assert printed is None, f"what is printed before {content} is not on the page"
            printed = run(content, tmp_path)
        elif language == "text":
            if not matches(content, printed):
                differing.append((content, printed))
            if f"{ELISION}\n" not in content:
                part = f"```text\n{printed}```\n"
            printed = None
        new.append(part)
    assert printed is None
    if differing and "UPDATE_GOLDEN" in os.environ:
        page.write_text("".join(new), encoding="utf-8")
    assert not differing, "\n".join(f"--- the page\n{said}--- printed\n{found}" for said, found in differing)
    assert len(new) > 10, "a page of a tutorial has commands"


def test_what_a_line_of_dots_stands_for():
    assert matches("a\n…\nd\n", "a\nb\nc\nd\n") and matches("…\nd\n", "d\n") and matches("…\n", "")
    assert not matches("a\n…\nd\n", "a\nb\n") and not matches("a\nd\n", "a\nb\nd\n") and not matches("a\n", "b\na\n")
