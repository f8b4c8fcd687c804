"""Runs in your hands: some steps of a collapse by discrete elements, some positions of a passage, with a look in between."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from . import _extrados
from ._progress import Wanted, told
from .errors import argument
from .results import Moment, Passage

if TYPE_CHECKING:
    from .results import Numbers

__all__ = ["CollapseRun", "Ended", "Frame", "PassageRun"]


@dataclass(frozen=True, eq=False)
class Frame:
    """Blocks, contacts and particles at one moment: arrays of their own, which the run does not change."""

    load_kn_per_m: float
    iterations: int
    centres_m: Numbers
    """Centre of mass of each block, (blocks, 2)."""
    angles_rad: Numbers
    """Rotation of each block since it was built, (blocks,)."""
    velocities_m_per_s: Numbers
    stresses_pa: Numbers
    """Average stress xx, yy, xy of each block, tension positive, (blocks, 3)."""
    contact_points_m: Numbers
    contact_compressions_n_per_m: Numbers
    contact_shears_n_per_m: Numbers
    particle_centres_m: Numbers
    particle_radii_m: Numbers

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Frame):
            return NotImplemented
        import numpy

        return all(numpy.array_equal(value, getattr(other, name), equal_nan=True) for name, value in vars(self).items())

    def __hash__(self) -> int:
        return hash((self.load_kn_per_m, self.iterations))


@dataclass(frozen=True)
class Ended:
    """What a run of steps has found."""

    last_stable_load_kn_per_m: float | None
    collapse_load_kn_per_m: float | None
    iterations_total: int


class _Run:
    """A run in the hands of its caller."""

    def __reduce__(self) -> Any:
        raise TypeError(f"a {type(self).__name__} goes on where it was made and cannot be pickled or copied; what it gives can be")


class CollapseRun(_Run):
    """A collapse by discrete elements that goes on when it is told to. Its numbers are those of `collapse(method="dem")`. Ctrl-C leaves it
    where it is: `advance` goes on from there.

    >>> import extrados
    >>> run = extrados.Bridge.example("bridgemill").collapse_run()
    >>> run.advance(100) is None
    True
    >>> run.frame().centres_m.shape
    (64, 2)
    """

    def __init__(self, project: _extrados.Project, options: dict[str, Any]) -> None:
        self._run = _extrados.CollapseRun(project, options)

    def advance(self, steps: int) -> str | None:
        """Goes on for so many steps or to the end of the run: then it gives the status."""
        return self._run.advance(_count("steps", steps))

    @property
    def load_kn_per_m(self) -> float:
        """The load that acts now."""
        return _held(self._run.load())

    def frame(self) -> Frame:
        """Blocks, contacts and particles as they are now."""
        return Frame(**_held(self._run.frame()))

    def finish(self) -> Ended:
        """Ends the run."""
        return Ended(*_held(self._run.finish()))


class PassageRun(_Run):
    """A passage that goes on when it is told to. Its numbers are those of :meth:`extrados.Bridge.respond`."""

    def __init__(self, project: _extrados.Project, options: dict[str, Any], tell: Any = None) -> None:
        self._run = _extrados.PassageRun(project, options, tell)

    @property
    def sensors(self) -> list[str]:
        """Names of the sensors."""
        return self._run.sensors()

    @property
    def positions(self) -> int:
        """How many positions there are."""
        return self._run.positions()

    def advance(self, positions: int = 1, *, progress: Wanted = None) -> str | None:
        """Moves the train on; gives the status once the passage has ended."""
        with told(progress) as tell:
            return self._run.advance(_count("positions", positions), tell)

    @property
    def place(self) -> tuple[float, float] | None:
        """Time [s] and position of the first axle [m] that were reached last; None before the first."""
        return self._run.place()

    @property
    def values_si(self) -> Numbers:
        """Values of the sensors there in m, strain or Pa, self-weight taken off."""
        return self._run.values()

    def moment(self) -> Moment:
        """Displacements, stresses and joints there; under self-weight alone before the first position."""
        held = _held(self._run.moment())
        return Moment(held, held.place()[0])

    def finish(self, *, progress: Wanted = None) -> Passage:
        """Ends the passage where it is; one that has not crossed has the status "cancelled"."""
        with told(progress) as tell:
            return Passage(_held(self._run.finish(tell)))


def _count(name: str, value: Any) -> int:
    if isinstance(value, bool) or not hasattr(value, "__index__") or not 0 < value.__index__() < 2**63:
        raise argument(f"{name} = {value!r} cannot be used", "give a whole number of at least 1")
    return value.__index__()


def _held(value: Any) -> Any:
    if value is None:
        raise argument("the run has ended", "make another one")
    return value
