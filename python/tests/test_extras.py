"""What an installation brings: `[test]` is light, and `[test-all]` holds everything that a test can use."""

import re

import pytest

HEAVY = {"jupyter", "dask", "distributed", "pyarrow", "polars", "scipy", "pyright", "emcee", "ipykernel", "h5py"}
IMPORTED_AS = {"scipy.io": "scipy", "dask.distributed": "dask", "matplotlib.figure": "matplotlib", "matplotlib.image": "matplotlib", "matplotlib.pyplot": "matplotlib"}


@pytest.fixture
def extras(root):
    tomllib = pytest.importorskip("tomllib")
    return tomllib.loads((root / "pyproject.toml").read_text())["project"]["optional-dependencies"]


def packages(extras, name) -> set[str]:
    """Packages that an extra brings by itself and by those that it names."""
    found = set()
    for one in extras[name]:
        package, others = re.match(r"([\w.-]+)(?:\[([\w,-]+)\])?", one).groups()
        if package == "extrados":
            found |= set().union(*(packages(extras, other) for other in others.split(",")))
        else:
            found.add(package.lower())
    return found


def test_the_quick_tests_need_nothing_heavy(extras):
    quick = packages(extras, "test")
    assert "pytest" in quick and not quick & HEAVY


def test_ci_installs_all_that_is_tested(extras, root):
    everything = packages(extras, "test-all")
    assert everything == set().union(*(packages(extras, name) for name in extras)) and everything >= HEAVY - {"distributed"}
    assert '"$wheel[test-all]"' in (root / ".ci/python").read_text()
    for path in (root / "python/tests").glob("test_*.py"):
        for name in re.findall(r'importorskip\("([^"]+)"\)', path.read_text()):
            assert IMPORTED_AS.get(name, name) in everything | {"tomllib"}, f"{path.name}: {name}"
