"""Fields of results. Made from the results themselves: EXTRADOS_WRITE_DOCS=1 cargo test -p outcome --test written"""

from __future__ import annotations

from typing import Any, Literal

Method = Literal["dem", "limit", "path", "fe"]
"""Methods: discrete elements, limit analysis, the equilibrium path, finite elements."""


class Collapse:
    """Fields of `extrados.collapse/1`."""

    method: str
    """By which method."""
    analysis: str
    """What was sought."""
    headline_kn_per_m: float
    """The load that is carried, by the method that gives least, per metre of width [kN/m]."""
    headline_kn: float
    """The same on the whole width [kN]."""
    headline_from: str
    """Which method gives it, in words."""
    last_stable_load_kn_per_m: float | None
    """Largest load carried; none where none is known [kN/m]."""
    last_stable_load_kn: float | None
    """The same on the whole width [kN]."""
    collapse_load_kn_per_m: float | None
    """Load at collapse [kN/m]."""
    collapse_load_kn: float | None
    """The same on the whole width [kN]."""
    help_left_out: list[str]
    """What may help the bridge and may come and go: it is not counted."""
    with_help: list[dict[str, Any]]
    """What it would add."""
    stalled_load_kn_per_m: float | None
    """Load step that neither came to rest nor collapsed [kN/m]."""
    load_step_kn_per_m: float | None
    """Load increment [kN/m]."""
    load_step_kn: float | None
    """The same on the whole width [kN]."""
    reference_load_kn_per_m: float
    """Load of the file: a load factor of one [kN/m]."""
    limit_load_kn_per_m: float | None
    """Limit load of the same blocks with infinitely stiff joints that never crush, beside a discrete element run [kN/m]."""
    crushing_limit_load_kn_per_m: float | None
    """The same with joints that crush, where the masonry has a strength [kN/m]."""
    bonded_rings_load_kn_per_m: float | None
    """Limit load of the same rings bonded into one, beside rings on one another with friction alone between them [kN/m]."""
    width_m: float
    """Width of the barrel [m]."""
    load_factor: float | None
    """How often the loads of the file are carried."""
    axles: list[dict[str, Any]]
    """Axles of the file, on widths of their own."""
    hinges: list[dict[str, Any]]
    """Hinges of the mechanism."""
    sliding_joints: list[dict[str, Any]]
    """Middles of joints that slide: `x_m`, `y_m`."""
    max_compressive_stress_mpa: float | None
    """Largest compressive stress [MPa]."""
    blocks: int
    """Number of blocks."""
    particles: int
    """Number of particles."""
    contacts: int
    """Number of contact points."""
    path: list[dict[str, Any]]
    """The load path."""
    iterations_total: int
    """Iterations in all."""
    time_step_s: float
    """Time step used [s]."""
    critical_time_step_s: float
    """Critical time step from the largest eigenvalue [s]."""
    single_mass_time_step_s: float
    """Critical time step from the one-degree-of-freedom estimate [s]."""
    damping: str
    """Damping, in words."""
    contact_length: str
    """Which length a contact stands for."""
    energy_drift: float
    """What the energy account leaves unexplained, relative to the work done."""
    friction: str
    """The flow rule that the numbers belong to."""
    lower_bound_kn_per_m: float | None
    """Lower bound, recomputed from the forces [kN/m]."""
    upper_bound_kn_per_m: float | None
    """Upper bound, recomputed from the mechanism [kN/m]."""
    associated_load_kn_per_m: float | None
    """The associated collapse load, beside the other where friction is non-associated [kN/m]."""
    non_associated_load_kn_per_m: float | None
    """The non-associated collapse load, beside the other where walls are analysed with associated friction [kN/m]."""
    without_fill_pressure_load_kn_per_m: float | None
    """Load without the fill's pressure against movement; only where the file has it act [kN/m]."""
    full_fill_pressure_load_kn_per_m: float | None
    """Load with all of the fill's passive pressure, where it presses [kN/m]."""
    non_associated_spread_kn_per_m: list[float] | None
    """The load in the mechanism without dilation, or the least behind the largest where loads come and go, and the largest [kN/m]."""
    unlimited_strength_load_kn_per_m: float | None
    """Collapse load of joints that never crush; the same as the collapse load where the file gives no strength [kN/m]."""
    equilibrium_residual: float | None
    """Largest out-of-balance force, relative to the permanent loads."""
    yield_violation: float | None
    """Largest excess over the strength, relative to the permanent loads."""
    solver_iterations: int
    """Iterations of the solver."""
    thrust_line: list[dict[str, Any]]
    """Points of all lines of thrust."""
    bound_ratio: float | None
    """Upper over lower bound."""
    elements: int
    """Triangles of the last mesh."""
    mobilised_share: float
    """Share of cohesion and of the tangent of the friction angle that is mobilised."""
    dilatancy_angle_deg: float
    """Dilatancy angle [°]."""
    associated_bounds_kn_per_m: list[float] | None
    """Both bounds of a soil that dilates by its friction angle, at the same share [kN/m]."""
    iterated_load_kn_per_m: float | None
    """Load at which the iteration for flow with less dilation settled: an estimate, and no bound [kN/m]."""
    plane_strain_load_kn_per_m: float | None
    """Lower bound in plane strain, where spandrel walls bound the stress out of the plane [kN/m]."""
    wall_gives: str | None
    """How a piece of spandrel wall gives way in the mechanism: "tilts" or "slides"."""
    wall_gives_at: list[float] | None
    """The ends of that piece along the bridge, in m."""
    range_shares: list[float]
    """The least and the largest share that the range is for."""
    range_kn_per_m: list[float] | None
    """Lower bound at the least share and upper bound at the largest one [kN/m]."""
    permanent_share: float | None
    """Share of the permanent loads that is carried, where they are not."""
    load_left_out: float
    """Share of the loads that stands beyond the ends of the fill and is left out."""
    flow_violation: float | None
    """Largest velocity that the flow rule does not allow, relative to the fastest."""
    meshes: list[dict[str, Any]]
    """Every mesh: `elements`, `lower_bound_kn_per_m`, `upper_bound_kn_per_m`."""
    peak_load_kn_per_m: float | None
    """The largest load in balance [kN/m]."""
    ended: str
    """How it ended."""
    contact: str | None
    """Where joints carry what presses them."""
    permissible: list[dict[str, Any]]
    """Loads at which states are first reached that a bridge should not come to in service."""
    over_stiffness: list[dict[str, Any]] | None
    """What joints of other stiffness would carry: `times` that of the result, `last_stable_load_kn_per_m`."""
    snaps: int
    """How often balance was lost and found again close by, as where a hinge moves to the next joint."""
    fill_pressure_mobilised: float | None
    """What movement has mobilised at the largest load, as a share of what it could."""
    degrees_of_freedom: int
    """Free components of displacement."""
    springs_per_joint: int
    """Springs across each joint, the outermost at its edges."""
    softening: float | None
    """How much farther the load moves for a little more of it at the end than at the start; none where it has no end."""
    minimum_thickness_m: float
    """Least thickness of all rings together at the crown of the first span [m]."""
    minimum_thickness_factor: float
    """Share of the given thickness that just stands."""
    thickness_factor_that_falls: float
    """The largest share of it that was seen not to stand."""
    minimum_thickness_over_mean_radius: float | None
    """The least thickness over the radius of the ring's middle line, where the intrados is a circle."""
    last_stable_movement_m: float | None
    """Last movement at which the bridge came to rest [m, or rad where only a rotation is given] [m]."""
    collapse_movement_m: float | None
    """Smallest movement at which it collapsed [m]."""
    movement_step_m: float
    """Increment [m]."""
    packing: dict[str, Any] | None
    """The packing of particles, where the fill is made of them."""
    combination: dict[str, Any] | None
    """Both strips together, where walls are analysed beside the fill."""
    wall_strip: dict[str, Any] | None
    """The strip below the walls, where this is the one between them."""
    tolerance: float
    """Tolerance of the method."""
    seed: int
    """Seed of whatever is random."""


class Sweep:
    """Fields of `extrados.sweep/1`."""

    governing: dict[str, Any] | None
    """The position with the least load factor, or the least bound on it."""
    help_left_out: list[str]
    """What may help the bridge and may come and go: it is not counted."""
    with_help: list[dict[str, Any]]
    """What it would add."""
    positions_not_converged: int
    """At how many positions a case found no answer."""
    step_m: float
    """Distance between positions, before the worst one was sought between them [m]."""
    positions: list[dict[str, Any]]
    """Positions from left to right."""


class VehicleSweep:
    """Fields of `extrados.vehicle-sweep/1`."""

    rule: dict[str, Any]
    """The rule with its factors and their sources: `code`, `title`, `source`, `factors`."""
    weight_combinations: list[dict[str, Any]]
    """The combinations of factors on weights that were tried."""
    step_m: float
    """Distance between positions [m]."""
    positions_not_converged: int
    """At how many positions a case was not answered, over all vehicles."""
    grades: list[dict[str, Any]] | None
    """What the bridge is worth in the grades of the load models that have them."""
    governing: dict[str, Any] | None
    """The governing position, as in sweeps of the file's own loads, with its vehicle and its `adequacy_factor`."""
    vehicles: list[dict[str, Any]]
    """Every vehicle, in the order of the plan."""
    restrictions: list[dict[str, Any]] | None
    """Vehicles of the weight restrictions that the rule names, lightest first up to the first that is not carried: moved where a vehicle of the plan is not."""
    discrete_elements: dict[str, Any] | None
    """The governing case by discrete elements, where the plan asks for it."""
    collapse: dict[str, Any] | None
    """The governing case as a collapse analysis."""


class Passage:
    """Fields of `extrados.respond/1`."""

    train: str
    """Name of the train."""
    speed_km_per_h: float
    """Its speed [km/h]."""
    analysis: str
    """At rest at every position, or with inertia."""
    kinematics: str
    """On the bridge as built, or deformed."""
    path: str
    """How positions were solved."""
    reason: str | None
    """Why it ended early, where it did not complete."""
    channels: list[dict[str, Any]]
    """Records of the sensors; where nothing crosses, their values in the positions of the load test."""
    positions: list[str]
    """Positions of the load test: `name`, `channels`, in its order."""
    degrees_of_freedom: int
    """Unknowns of the model, before anything is condensed."""
    condensed_degrees_of_freedom: int | None
    """Unknowns that iterate, where linear parts are condensed."""
    load_positions: int
    """Positions at which equilibrium was sought."""
    iterations_total: int
    """Iterations of all steps."""
    open_joints: int
    """Most joints that were open somewhere at the same time."""
    plastic_points: int
    """Most points that yielded at the same time."""
    locking_elements: int
    """Most elements all of whose points yielded at the same time."""
    effective_width_m: float
    """Width of the bridge that carries an axle [m]."""
    tolerance: float
    """Asked out-of-balance force over applied force."""
    time_step_s: float | None
    """Time between two positions [s]."""
    first_position_m: float | None
    """First position of the first axle [m]."""
    last_position_m: float | None
    """Last position of the first axle [m]."""
    nodes: int
    """Nodes of the mesh."""
    elements: int
    """Elements of the mesh."""
    zones: list[dict[str, Any]]
    """Parts of the mesh: `name`, `elements`."""
    moments: list[dict[str, Any]]
    """The bridge at chosen moments; the first is under self-weight alone."""


class Update:
    """Fields of `extrados.update/1`."""

    train: str
    """Name of the train."""
    search: str | None
    """The search whose end is the answer; none where none came to an end."""
    reason: str | None
    """Why, where it did not complete."""
    parameters: list[dict[str, Any]]
    """Every parameter: `name`, `value`, `unit`, `interval_95`, `identifiable` and so on."""
    uncertainty_from: str | None
    """Where standard deviations, intervals and correlations come from: the linearised problem or the sampled posterior."""
    correlation: list[list[float]]
    """Correlation of the parameters; empty where it is not known."""
    error_norm: float | None
    """Error norm of the answer, of a full passage."""
    error_norm_in_search: float | None
    """The same as the search saw it, from its slices."""
    initial_error_norm: float | None
    """Error norm of the start model."""
    evaluations: int
    """Evaluations of the model that the answers rest on, each point once."""
    evaluations_computed: int
    """Of these, evaluations that this run did itself."""
    channels: list[dict[str, Any]]
    """Every channel: `name`, `unit`, `measured_peak`, `model_peak`, `shape_correlation`, `weight`, `error` and so on."""
    positions: list[dict[str, Any]]
    """Positions of the load test: `name`, and `channels` with what each sensor read (`measured`) and the model gives (`start`, `updated`)."""
    searches: list[dict[str, Any]]
    """All searches, in the order in which they were made."""
    sensitivity: list[dict[str, Any]]
    """Sweeps of the model about the start, or of its straight line about the answer: `parameter`, `range`, `rank` and so on."""
    stages: list[dict[str, Any]]
    """Stages of the paper's search: `parameters`, `case`, `frozen` and so on."""
    naive_error_norm: float | None
    """Error norm of the values that single sweeps give, of the paper's search."""
    rank: int | None
    """Rank of the scaled derivatives at the answer."""
    condition: float | None
    """Their condition number."""
    told: list[str]
    """What the records tell at the answer, in words."""
    model_error: float | None
    """The model's error as a share of the response, by the linearised problem."""
    common_gain_deviation: float | None
    """Standard deviation of the gain that all channels share (axle loads, width) before the records."""
    common_gain: dict[str, Any] | None
    """That gain as the records leave it: `mean`, `standard_deviation`."""
    posterior: dict[str, Any] | None
    """What the sampled posterior says of itself: `model_error`, `log_evidence`, `r_hat` and so on."""
    records: dict[str, Any]
    """The records: `runs`, `done`, `findings`, `peaks` and so on."""
    load_positions: int
    """Positions of the train."""


class Study:
    """Fields of `extrados.vary/1`."""

    command: str
    """The command that was repeated."""
    method: str
    """By which method the file's own plan has it analyse."""
    analysis: str
    """Which analysis the file's own plan has it make."""
    design: str
    """One at a time, or all against all."""
    outcome: str
    """Name of the number that figures and sensitivities are about."""
    outcome_resolution: float
    """Changes of that number up to this are the search's and not the bridge's."""
    quantities: list[dict[str, Any]]
    """What was varied: `quantity`, `unit`, `own`, `values`."""
    baseline: dict[str, Any] | None
    """The bridge as its file has it, as one of the rows."""
    rows: list[dict[str, Any]]
    """Every run in the order of the design: `values`, `status`, `outcomes` and so on."""
    sensitivity: list[dict[str, Any]]
    """What each quantity does to the number: `low`, `high`, `elasticity`, `trend` and so on."""
    runs: int
    """How many runs there are, the bridge as its file has it among them."""
    runs_from_cache: int
    """How many of them were taken from an earlier command."""


class Assessment:
    """Fields of `extrados.assess/1`."""

    verdict: str
    """In a sentence or two."""
    headline: str
    """The rung of the ladder, in a few words."""
    head: str
    """The verdict in a line: by what it is given, and what it is to be read with."""
    beside: list[str]
    """What stands beside it, most important first."""
    by: str | None
    """Code of the rule of `[sweep]`, or "file" for the factor of `[assess]`; none where strength is not asked for."""
    by_name: str
    """The same as it is said: "CS 454"."""
    level: str | None
    """What is asked for where the vehicles stand for grades: "18 t"."""
    carried: str | None
    """What is carried of grades, where that is settled and less than what is asked for: "RA2", "less than 3 t"."""
    to_confirm: int
    """How many factors are to be confirmed."""
    factors_to_confirm: list[str]
    """Factors that act on this bridge and are recalled or assumed, each with its value."""
    skipped: list[str]
    """Stages that the file asks for and the command left out."""
    load_cases_left_out: list[str]
    """Codes of load cases of the rule that apply to the spans and were not moved."""
    doubtful: list[str]
    """Doubtful values of the file, of its vehicles and of its rule: their codes."""
    assumed_values: list[str]
    """Values of the file that nobody measured: paths of those whose remark begins with "assumed"."""
    changed_factors: list[dict[str, Any]]
    """Factors that differ from those of the library's rule."""
    taken: list[str]
    """What the file does not give and was taken, and what it takes otherwise than usual, in words."""
    model_factor: dict[str, Any] | None
    """The model factor in force, where the factors are not those of a standard."""
    record: dict[str, Any] | None
    """What tests to collapse carried of the predictions of the same method."""
    strength_assessed: bool
    """Whether an ultimate check was made under factors with a source, and none came to no end."""
    missing: list[str]
    """What is missing, in words; empty where it was assessed."""
    qualifications: list[str]
    """What qualifies a check that was made, in words."""
    checks: list[dict[str, Any]]
    """Every comparison: `code`, `title`, `value`, `limit`, `unit`, `utilisation`, `met` and so on."""
    not_made: list[dict[str, Any]]
    """Checks that could not be made: `code`, `title`, `why`, `analysis_failed`."""
    governing: dict[str, Any] | None
    """The comparison that uses most of its limit: `code`, `title`, `load_model`, `utilisation`, `met`."""
    condition: list[dict[str, Any]]
    """What records say of its materials."""
    next_steps: list[dict[str, Any]]
    """What to do next, by rule."""
    statics: dict[str, Any] | None
    """What it weighs, and what it hands to the ground at rest; none where it cannot be cut into blocks."""
    sensitivity: dict[str, Any] | None
    """What changes the governing utilisation."""
    service: dict[str, Any] | None
    """Loads in service."""
    collapse: dict[str, Any] | None
    """The file's own loads at collapse, where that was analysed."""
    shortened: list[dict[str, Any]] | None
    """Uniform loads of which a part does more harm than the whole."""
    vehicles: dict[str, Any] | None
    """Vehicles moved over the bridge under the factors of a rule."""
    cases: dict[str, Any] | None
    """What the file's named cases carry."""
    support_movement: dict[str, Any] | None
    """The movement of a support that makes a mechanism."""
    update: dict[str, Any] | None
    """What updating found."""
