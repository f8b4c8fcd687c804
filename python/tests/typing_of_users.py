"""What users write, for the type checker alone: no result is of an unknown type."""

import extrados
import numpy as np
import numpy.typing as npt

bridge: extrados.Bridge = extrados.Bridge.example("tiny").with_(span_1_thickness="0.6 m")
found: extrados.Collapse = bridge.collapse(method="limit", friction="associated")
load: float | None = found.last_stable_load_kn_per_m
points: npt.NDArray[np.float64] = found.hinge_points_m
figure: extrados.Figure = found.figure("mechanism")
finding: extrados.Finding = bridge.check().findings[0]
passage: extrados.Passage = bridge.respond(speed="45 km/h")
values: npt.NDArray[np.float64] = passage.records["crown"].values_si
study: extrados.Study = bridge.vary("joint.friction_angle=30deg..40deg:3", progress=lambda told: print(told.fraction))
by_values: extrados.Study = bridge.vary({"joint.friction_angle [deg]": np.linspace(30.0, 40.0, 3)}, span_1_thickness=["0.6 m"], method="limit")
again: bool = found == bridge.collapse(method="limit")
label: str = found.plot("mechanism").get_xlabel()
bridge.collapse(method="magic")  # pyright: ignore[reportArgumentType]
found.no_such_load_kn  # pyright: ignore[reportAttributeAccessIssue]
