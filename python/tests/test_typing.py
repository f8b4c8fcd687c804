"""Types are checked, and examples in documentation run."""

import doctest
import importlib
import pkgutil
import subprocess
import sys

import extrados
import pytest


def modules() -> list[str]:
    return [f"extrados.{one.name}" for one in pkgutil.iter_modules(extrados.__path__) if one.name != "_extrados"]


@pytest.mark.parametrize("name", ["extrados", *modules()])
def test_examples_run(name, monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    found = doctest.testmod(importlib.import_module(name), optionflags=doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE)
    assert found.failed == 0


def test_the_page_runs(root):
    failed, tried = doctest.testfile(str(root / "docs/python.md"), module_relative=False, optionflags=doctest.ELLIPSIS)
    assert failed == 0 and tried >= 10


def test_types(root):
    pytest.importorskip("pyright")
    done = subprocess.run([sys.executable, "-m", "pyright", "--pythonpath", sys.executable], cwd=root, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout


def test_the_stub_has_what_the_module_has(root):
    from extrados import _extrados

    stub = (root / "python/extrados/_extrados.pyi").read_text()
    for name in dir(_extrados):
        if not name.startswith("__"):
            assert f"class {name}" in stub or f"def {name}(" in stub, name
            for method in dir(getattr(_extrados, name)) if isinstance(getattr(_extrados, name), type) else []:
                assert method.startswith("__") or f"def {method}(" in stub, f"{name}.{method}"


def test_everything_public_has_a_docstring():
    for name in extrados.__all__:
        thing = getattr(extrados, name)
        assert thing.__doc__, name
        for attribute, member in vars(thing).items() if isinstance(thing, type) and thing.__module__.startswith("extrados") else []:
            if not attribute.startswith("_") and (callable(member) or isinstance(member, property)):
                shown = attribute in {"errors", "warnings"} or getattr(member, "__doc__", None) or issubclass(thing, extrados.State)
                assert shown, f"{name}.{attribute}"
