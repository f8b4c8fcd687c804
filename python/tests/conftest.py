"""What tests share: the clone, and the command built from it."""

import os
import shutil
import signal
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="session", autouse=True)
def ctrl_c():
    """A shell starts what it runs in the background deaf to Ctrl-C, and Python leaves it so: tests of it could not pass there."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


@pytest.fixture(scope="session")
def root() -> Path:
    return ROOT


@pytest.fixture(scope="session")
def command() -> str:
    """The command `extrados` of the same sources; EXTRADOS_COMMAND names another one."""
    target = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target"))
    found = os.environ.get("EXTRADOS_COMMAND") or shutil.which("extrados", path=str(target / "release"))
    if not found:
        pytest.skip("the command is not built: cargo build --release")
    return found


@pytest.fixture(scope="session")
def small_passage():
    """The railway arch under its train on a coarse mesh, over the first spans alone."""
    import extrados

    text = extrados.Bridge.example("passage").text
    text = text.replace('time_step = "0.005 s"', 'time_step = "0.1 s"\nfrom = "2 m"\nto = "16 m"')
    text = text.replace('size = "0.15 m"', 'size = "0.4 m"')
    return extrados.Bridge.parse(text, name="few.toml")
