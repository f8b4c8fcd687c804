"""The page of the package's names is made from the package: EXTRADOS_WRITE_DOCS=1 writes it anew."""

import inspect
import os
import re
from pathlib import Path
from typing import Any, get_args

import extrados
from extrados import bridge

PAGE = "docs/python-reference.md"
HEAD = """# Python, name by name

Purpose: every public class, method and function of the package with its arguments. Made from the package itself by
`EXTRADOS_WRITE_DOCS=1 python -m pytest python/tests/test_pages.py`. How they are used stands in [Python](python.md), what results hold in
[Results](results.md).
"""
# In the order in which they are met.
ORDER = [
    "Bridge", "Blocks", "Quantity", "Check", "examples", "threads", "Progress",
    "Result", "Collapse", "Sweep", "VehicleSweep", "Passage", "Update", "Study", "Assessment", "Cases", "Comparison", "Figure", "Table",
    "CollapseRun", "PassageRun", "State",
    "Error", "BridgeError", "FileError", "RecordsError", "SetupError", "ArgumentError", "InternalError", "Interrupted", "Finding",
]  # fmt: skip
MODULES = {"records": extrados.records}
# Arguments that are one of some words, by the name that they have in the calls.
WORDS = {"Method": bridge.Method, "Analysis": bridge.Analysis, "Friction": bridge.Friction, "Stage": bridge.Stage}


def words(doc: str) -> str:
    """A docstring as Markdown: examples in fences, references as code."""
    doc = re.sub(r":\w+:`~?([^`]*)`", r"`\1`", doc.replace("``", "`"))
    lines: list[str] = []
    inside = False
    for line in doc.splitlines():
        begins = line.startswith(">>>")
        if begins and not inside:
            lines.append("```python")
            inside = True
        if inside and not line.strip():
            lines.append("```")
            inside = False
        lines.append(line)
    return "\n".join([*lines, "```"] if inside else lines)


def signature(name: str, what: Any) -> str:
    try:
        shown = str(inspect.signature(what))
    except (TypeError, ValueError):
        return name
    shown = re.sub(r"^\((self|cls)(, /)?(, )?", "(", shown)
    # Annotations are texts, and defaults that are objects have no name.
    shown = re.sub(r"(: |-> )(['\"])(.*?)\2", r"\1\3", shown)
    shown = name + re.sub(r"<[^>]*>", "...", shown)
    return shown if len(shown) <= 110 else broken(shown)


def broken(call: str) -> str:
    """A long call with a line for each argument."""
    lines, depth = [""], 0
    for k, c in enumerate(call):
        depth += (c in "([{") - (c in ")]}")
        if c == ")" and depth == 0:
            lines += [call[k:]]
            break
        lines[-1] += c
        if (c == "(" and depth == 1) or (c == "," and depth == 1):
            lines.append("    ")
    return "\n".join(line.replace("     ", "    ", 1).rstrip() for line in lines)


def members(cls: type) -> list[tuple[str, Any]]:
    """Its own public members, and those of parts that are not public, in the order of the source."""
    shown = {name for name in extrados.__all__ if name != cls.__name__}
    found: dict[str, Any] = {}
    for one in cls.__mro__:
        if one is cls or (one.__module__.startswith("extrados") and one.__name__ not in shown and one.__module__ != "extrados._keys"):
            found = {**found, **{name: value for name, value in vars(one).items() if name not in found and not name.startswith("_")}}
    # A plain value has the words of its type, and none of its own.
    return [(name, value) for name, value in found.items() if inspect.getdoc(unwrapped(value)) and not isinstance(value, (str, int, float, tuple, dict))]


def unwrapped(value: Any) -> Any:
    if isinstance(value, (classmethod, staticmethod)):
        return value.__func__
    return value


def is_data(value: Any) -> bool:
    return not callable(unwrapped(value)) or isinstance(value, property)


def of_class(name: str, cls: type) -> list[str]:
    page = [f"## {name}", words(inspect.getdoc(cls) or "")]
    data = [(key, value) for key, value in members(cls) if is_data(value)]
    if data:
        row = "| `{}` | {} |"
        page.append("\n".join(["| Attribute | |", "|---|---|", *(row.format(key, first(value)) for key, value in data)]))
    for key, value in members(cls):
        if not is_data(value):
            call = unwrapped(value)
            page += [f"### {name}.{key}", f"```python\n{signature(f'{name}.{key}', call)}\n```", words(inspect.getdoc(call) or "")]
    return page


def first(value: Any) -> str:
    doc = inspect.getdoc(value) or ""
    return " ".join(words(doc.split("\n\n")[0]).split()).replace("|", "\\|")


def page() -> str:
    rows = [f"| `{name}` | {', '.join(f'`{word!r}`'.replace(chr(39), chr(34)) for word in get_args(literal))} |" for name, literal in WORDS.items()]
    parts = [HEAD.strip(), "Arguments of these types are one of these words:", "\n".join(["| Type | Words |", "|---|---|", *rows])]
    for name in ORDER:
        what = getattr(extrados, name)
        if inspect.isclass(what):
            parts += of_class(name, what)
        else:
            parts += [f"## {name}", f"```python\n{signature(f'extrados.{name}', what)}\n```", words(inspect.getdoc(what) or "")]
    for name, module in MODULES.items():
        parts += [f"## {name}", words(inspect.getdoc(module) or "")]
        for key, value in vars(module).items():
            if inspect.isfunction(value) and value.__module__ == module.__name__ and not key.startswith("_") and inspect.getdoc(value):
                call = f"extrados.{name}.{key}"
                parts += [f"### {name}.{key}", f"```python\n{signature(call, value)}\n```", words(inspect.getdoc(value) or "")]
    return "\n\n".join(part.strip() for part in parts) + "\n"


def test_every_name_is_on_the_page():
    missing = set(extrados.__all__) - set(ORDER) - {"errors", "records", "results", "runs"}
    assert not missing, f"give them a place in ORDER: {sorted(missing)}"
    for name in ORDER:
        assert inspect.getdoc(getattr(extrados, name)), f"{name} says nothing of itself"


def test_the_page_is_that_of_the_package(root: Path):
    place = root / PAGE
    made = page()
    if os.environ.get("EXTRADOS_WRITE_DOCS") == "1":
        place.write_text(made, encoding="utf-8")
    assert place.read_text(encoding="utf-8") == made, f"EXTRADOS_WRITE_DOCS=1 writes {PAGE} anew"
