"""What scripts and notebooks are shown: representations, and suggestions."""

import extrados
import pytest


@pytest.fixture(scope="module")
def limit():
    return extrados.Bridge.example("bridgemill").collapse(method="limit")


@pytest.fixture(scope="module")
def dem():
    return extrados.Bridge.example("bridgemill").collapse(method="dem")


# ---- representations


def test_representations_are_short_and_say_units(dem, small_passage):
    assert repr(dem.figure("mechanism")) == "<extrados.Figure: 160 mm x 80.2 mm; Bridgemill, case 1: discrete elements; Mechanism at collapse, 216.9 kN/m>"
    table = dem.tables["contacts"]
    rows = len(dem.to_pandas("contacts"))
    assert repr(table).startswith(f"<extrados.Table: {rows} rows of 11 columns: load_kn_per_m, first_block, second_block, x_m, ")
    assert repr(table).endswith("and 3 more>") and str(table).startswith("load_kn_per_m,") and isinstance(table, str)
    assert repr(dem.tables["hinges"]) == "<extrados.Table: 4 rows of 6 columns: x_m, y_m, edge, rotation, first_side, second_side>"
    assert repr(dem.snapshots[0]) == f"<extrados.Snapshot: 0 kN/m, 64 blocks, {len(dem.snapshots[0].contact_stresses_pa)} contacts>"
    passage = small_passage.respond()
    record = next(iter(passage.records.values()))
    assert repr(record) == f"<extrados.Channel: {record.name} [{record.unit}], {len(passage.times_s)} values>"
    assert f"{passage.nodes} nodes, {passage.elements} elements" in repr(passage.fields[0])
    for shown in (dem, dem.figures, dem.tables, dem.snapshots[3], passage.fields, passage.records):
        assert max(map(len, repr(shown).split("extrados."))) < 250 and "<svg" not in repr(shown)


# ---- suggestions


def test_names_that_are_nearly_right(limit):
    for name, meant in (
        ("headlin", "did you mean headline_from or headline_kn or headline_kn_per_m?"),
        ("last_stabel_load_kn", "did you mean last_stable_load_kn or "),
        ("hinge", "did you mean hinge_blocks or hinge_points_m or hinges?"),
        ("to_panda", "did you mean to_pandas"),
    ):
        with pytest.raises(AttributeError) as refusal:
            getattr(limit, name)
        assert f"no `{name}`; {meant}" in str(refusal.value)
    with pytest.raises(AttributeError, match="no `qqqq`; it has .*headline_kn_per_m"):
        _ = limit.qqqq
    assert not hasattr(limit, "_repr_jpeg_")
