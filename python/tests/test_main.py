"""`python -m extrados` is the command where it is installed, and says how to get it where it is not."""

import os
import subprocess
import sys

import extrados
import pytest


def called(*arguments, **environment):
    """Without a command on PATH, unless it is given."""
    clean = {name: value for name, value in os.environ.items() if name != "EXTRADOS_COMMAND"} | {"PATH": os.devnull} | environment
    done = subprocess.run([sys.executable, "-m", "extrados", *arguments], env=clean, capture_output=True, text=True, check=False)
    return done.returncode, done.stdout, done.stderr


@pytest.fixture
def fake(tmp_path):
    if os.name != "posix":
        pytest.skip("the stand-in is a script of a shell")
    path = tmp_path / "extrados"
    path.write_text("#!/bin/sh\nfor one in \"$@\"; do echo \"<$one>\"; done\nexit 3\n")
    path.chmod(0o755)
    return path


def test_arguments_and_status_are_those_of_the_command(fake):
    told = "<collapse>\n<a bridge.toml>\n<--method>\n<limit>\n"
    arguments = ("collapse", "a bridge.toml", "--method", "limit")
    assert called(*arguments, PATH=str(fake.parent)) == (3, told, "")
    assert called(*arguments, EXTRADOS_COMMAND=str(fake)) == (3, told, "")


def test_without_the_command_it_says_how_to_get_it(tmp_path):
    status, out, told = called("collapse", "bridge.toml")
    assert (status, out) == (2, "") and "not on PATH" in told and "cargo install --path crates/cli" in told and "EXTRADOS_COMMAND" in told
    status, _, told = called(EXTRADOS_COMMAND=str(tmp_path / "none"))
    assert status == 2 and "EXTRADOS_COMMAND names" in told and "none" in told


def test_it_is_the_command_of_the_same_sources(command):
    status, out, _ = called("--version", EXTRADOS_COMMAND=command)
    assert status == 0 and extrados.__version__ in out
