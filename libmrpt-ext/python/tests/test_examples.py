import os
import subprocess
import sys
from pathlib import Path

import pytest

EXAMPLES = Path(os.environ["MRPT_EXT_SOURCE"]) / "libmrpt-ext/python/examples"


@pytest.mark.parametrize("name", sorted(path.name for path in EXAMPLES.glob("*.py")))
def test_the_example_runs(name, tmp_path):
    needs_figures = "matplotlib" in (EXAMPLES / name).read_text()
    if needs_figures:
        pytest.importorskip("matplotlib")
    done = subprocess.run([sys.executable, str(EXAMPLES / name)], cwd=tmp_path, capture_output=True, text=True, timeout=200)
    assert done.returncode == 0, done.stderr
    assert done.stdout
