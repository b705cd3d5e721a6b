"""The Python of README and docs/python.md runs as it is shown."""

import pathlib
import re

import pytest
from conftest import data

ROOT = pathlib.Path(__file__).resolve().parents[2]


@pytest.mark.parametrize("name", ["README.md", "docs/python.md"])
def test_blocks_of_python_run(name, tmp_path, monkeypatch):
    text = (ROOT / name).read_text(encoding="utf-8")
    blocks = re.findall(r"^```python\n(.*?)^```", text, re.DOTALL | re.MULTILINE)
    assert blocks
    for volume in re.findall(r'"([\w.]+\.raw)"', "".join(blocks)):
        (tmp_path / volume).symlink_to(data(f"volumes/{volume}"))
    monkeypatch.chdir(tmp_path)
    exec("\n".join(blocks), {})
