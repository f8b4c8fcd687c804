"""Ten thousand calls with arguments at random: each gives a result or an exception of a documented class, and none ends the interpreter.
EXTRADOS_RANDOM_CALLS asks for another number."""

import os
import random

import extrados
import numpy

NAMES = ("tiny", "bridgemill", "semicircle", "packhorse", "vehicles", "passage", "update")
ODD = [None, True, False, 0, -1, 3, 2**70, 0.5, -0.0, float("nan"), float("inf"), 1e-300, "", "x", "1 m", "0.6 m", "-2 m", "1 kN/m"]
ODD += ["35 deg", "nan m", "limit", "dem", "path", "fe", "load", "thickness", "points", "x1.1", "30deg..40deg:3", "\0", "ä" * 50, "'", '"""']
ODD += [b"bytes", [], [1], {}, {"a": 1}, (), object(), numpy.float64(2.0), numpy.array([1.0, numpy.nan]), numpy.array(["a"]), numpy.zeros((2, 2))]
ODD += ["uniform", "segmental", "45 km/h", "1e400 m", "9" * 400, numpy.datetime64("2020-01-01"), 1 + 2j, range(3)]
WORDS = ["method", "analysis", "friction", "contact", "contact_length", "contact_points", "resolution", "damping", "tolerance", "step_limit"]
WORDS += ["step", "speed", "path", "search", "skip", "grid", "outcome", "most_runs", "progress", "resume", "records_only", "colour"]


def stopping(budget: int):
    """A callback that ends long work."""
    left = [budget]

    def look(_):
        left[0] -= 1
        if left[0] < 0:
            raise TimeoutError

    return look


def mangled(dice: random.Random, text: str) -> str:
    lines = text.splitlines()
    for _ in range(dice.randrange(1, 4)):
        k = dice.randrange(len(lines))
        match dice.randrange(6):
            case 0:
                del lines[k]
                lines = lines or [""]
            case 1:
                lines.insert(k, dice.choice(lines))
            case 2:
                lines[k] = lines[k].replace("=", dice.choice(["= -", "= [", "=", "= {", "= \""]), 1)
            case 3:
                at = dice.randrange(len(lines[k]) + 1)
                lines[k] = lines[k][:at] + dice.choice(["\0", "ü", "9", "]", "'", "\\u12", "{{{{"]) + lines[k][at:]
            case 4:
                lines[k] = dice.choice(["[" * 3000, "a.b.c = 1", "x = " + "[" * 500, "\ufeff", "[[span]]"])
            case _:
                lines[k] = lines[k].replace("0", dice.choice("123456789e-."))
    return "\n".join(lines)


def call(dice: random.Random, bridge: extrados.Bridge, other: extrados.Bridge) -> None:
    words = {name: dice.choice(ODD) for name in dice.sample(WORDS, dice.randrange(4))}
    resume = words.get("resume")
    words["progress"] = stopping(1)
    kind = dice.randrange(16)
    quick = {"method": "limit", "progress": stopping(1)}
    if kind == 0:
        bridge.collapse(**words)
    elif kind == 1:
        bridge.sweep(**words)
    elif kind == 2:
        bridge.respond(**words)
    elif kind == 3:
        bridge.vary(*[dice.choice(ODD) for _ in range(dice.randrange(3))], **words)
    elif kind == 4:
        bridge.assess(**words)
    elif kind == 5:
        bridge.cases(**words)
    elif kind == 6:
        bridge.compare(dice.choice([other, *ODD]), **words)
    elif kind == 7:
        bridge.update(dice.choice(ODD), **words)
    elif kind in (8, 9, 10):
        paths = [one.path for one in bridge.quantities] if bridge.check().is_usable else ["joint.cohesion"]
        edited = bridge.with_({dice.choice([*paths, *map(str, ODD)]): dice.choice(ODD) for _ in range(dice.randrange(1, 3))})
        if dice.random() < 0.1:
            edited.collapse(**quick)
    elif kind == 11:
        extrados.Bridge.new(**{dice.choice(["span", "bridge", "load", "x"]): dice.choice(ODD) for _ in range(2)}).check()
    elif kind == 12:
        mine = extrados.Bridge.parse(mangled(dice, bridge.text), name="mine.toml")
        str(mine.check())
        if dice.random() < 0.1:
            mine.collapse(**quick)
    elif kind == 13:
        extrados.Bridge.parse(dice.choice(ODD)).check()
    elif kind == 14:
        extrados.State(dice.choice(ODD))
        bridge.collapse(resume=resume, **quick)
    else:
        found = other.collapse(method="limit")
        dice.choice([found.figure, found.outline_m, found.to_pandas, lambda name: getattr(found, name)])(dice.choice(ODD))


def test_calls_at_random():
    count = int(os.environ.get("EXTRADOS_RANDOM_CALLS", "10000"))
    dice = random.Random(5)
    bridges = [extrados.Bridge.example(name) for name in NAMES]
    weights = [60, 4, 20, 4, 1, 1, 1]
    ended: dict[str, int] = {}
    for number in range(count):
        bridge = dice.choices(bridges, weights)[0]
        try:
            call(dice, bridge, bridges[0])
            name = "answered"
        except extrados.InternalError as error:
            raise AssertionError(f"call {number}") from error
        except (extrados.Error, TimeoutError, TypeError, ValueError, AttributeError, OverflowError, KeyError) as error:
            # What Python itself refuses, such as an object where bytes are wanted, has its own classes; a message it must have.
            assert str(error) or isinstance(error, TimeoutError), number
            name = type(error).__name__
        ended[name] = ended.get(name, 0) + 1
    assert sum(ended.values()) == count
    assert ended["answered"] > count / 20 and ended["ArgumentError"] > count / 20 and ended["BridgeError"] > count / 20, ended
    assert extrados.Bridge.example("tiny").collapse(method="limit").status == "collapsed"
