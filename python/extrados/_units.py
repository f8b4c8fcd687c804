"""Quantities with units of other libraries, such as pint, as the texts of bridge files. They are known by what they can do: `to`, `magnitude` and `units`."""

from __future__ import annotations

from typing import Any

from .errors import argument

# Units that both write alike and mean the same by: what the caller wrote stays. A test asks pint for the size of each.
_ALIKE = frozenset(
    "m mm cm ft in yd deg rad mrad kg/m^3 t/m^3 g/cm^3 lb/ft^3 kN/m^3 N/m^3 MN/m^3 lbf/ft^3 MPa Pa kPa GPa N/m^2 kN/m^2 MN/m^2 N/mm^2 kN/mm^2 psi ksi "
    "lbf/in^2 lbf/ft^2 GPa/m Pa/m kPa/m MPa/m MPa/mm GPa/mm N/mm^3 lbf/in^3 kN N MN lbf kip kN/m N/m MN/m N/mm lbf/ft kip/ft m/s^2 rad/m deg/m kg t lb "
    "km/h m/s mph s ms Hz".split()
)
# Where the unit is another one: as the units of SI in pint and in bridge files. Weight per volume and stiffness per area have the same dimensions.
_SI = (
    *(("m", "m"), ("kg/m**3", "kg/m^3"), ("Pa", "Pa"), ("N", "N"), ("N/m", "N/m"), ("m/s**2", "m/s^2"), ("N*m**2", "Nm^2")),
    *(("m/s", "m/s"), ("s", "s"), ("Hz", "Hz"), ("kg", "kg"), ("Pa/m", "Pa/m")),
)


def is_quantity(value: Any) -> bool:
    """Whether something has a magnitude and units that it can be brought to."""
    return all(hasattr(value, name) for name in ("to", "magnitude", "units"))


def plain(name: str, value: Any) -> Any:
    """A quantity as a text such as "0.6 m", or as a number where it has no dimension; anything else as it is."""
    if not is_quantity(value):
        return value
    unit = _spelled(value.units)
    if unit == "":
        return _number(name, value.magnitude)
    if unit in _ALIKE:
        return f"{_number(name, value.magnitude)!r} {unit}"
    for theirs, ours in _SI:
        try:
            brought = value.to(theirs)
        except (AttributeError, TypeError, ValueError):
            continue
        return f"{_number(name, brought.magnitude)!r} {ours}"
    raise argument(f"{name} = {value} cannot be used", f"nothing in a bridge file has the unit {value.units}")


def _spelled(units: Any) -> str:
    try:
        short = format(units, "~C")
    except (TypeError, ValueError):
        short = str(units)
    short = short.replace(" ", "").replace("**", "^").replace("°", "deg")
    return "" if short == "dimensionless" else short


def _number(name: str, magnitude: Any) -> float:
    import math

    if getattr(magnitude, "shape", ()) != ():
        raise argument(f"{name} has {getattr(magnitude, 'size', 'several')} values", "give one")
    number = float(magnitude)
    if not math.isfinite(number):
        raise argument(f"{name} = {number} cannot be used", "give a number that is finite")
    return number
