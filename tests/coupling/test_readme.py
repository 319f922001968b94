"""The walkthrough of the README does what the README says."""

import re
import subprocess

from conftest import ROOT


def test_the_commands_of_the_readme_draw_the_closed_loops():
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    section = readme.split("\n## Close the loop\n")[1].split("\n## ")[0]
    [commands] = re.findall(r"```sh\n(.*?)```", section, re.DOTALL)
    picture = ROOT / "target/coupled/closed-loop.png"
    picture.unlink(missing_ok=True)
    subprocess.run(["bash", "-euo", "pipefail", "-c", commands], cwd=ROOT, check=True)
    assert picture.read_bytes().startswith(b"\x89PNG")
