"""The official client drives a bridge, and a sampler of others recovers the posterior of a small update problem through it."""

import os
import re

import extrados
import extrados.umbridge
import numpy
import pytest

umbridge = pytest.importorskip("umbridge")

TINY = extrados.Bridge.example("tiny")


@pytest.fixture(scope="module")
def client():
    model = extrados.umbridge.Model(TINY, {"joint.friction_angle": "deg", "masonry_density": "kg/m^3"}, ["collapse.last_stable_load_kn_per_m"], method="limit")
    with extrados.umbridge.Server(model, port=0) as server:
        yield umbridge.HTTPModel(server.url, "forward")


def test_the_client_finds_what_the_package_finds(client):
    assert client.get_input_sizes() == [2] and client.get_output_sizes() == [1]
    assert client.supports_evaluate() and not client.supports_gradient()
    found = TINY.with_(joint_friction_angle="33 deg", masonry_density="2100 kg/m^3").collapse(method="limit")
    assert client([[33.0, 2100.0]]) == [[found.last_stable_load_kn_per_m]]


def test_what_has_no_answer_is_an_error_and_never_a_number(client):
    for values in ([[95.0, 2200.0]], [[33.0, -1.0]], [[float("inf"), 2200.0]]):
        with pytest.raises(Exception, match="(?i)error|invalid|json"):
            client(values)
    with pytest.raises(extrados.ArgumentError, match="no number 'beauty'"):
        extrados.umbridge.Model(TINY, {"joint.friction_angle": "deg"}, ["collapse.beauty"])([35.0])
    with pytest.raises(extrados.ArgumentError, match="parameters"):
        extrados.umbridge.Model(TINY, {}, ["collapse.load_factor"])


def one_span() -> extrados.Bridge:
    """The railway arch as a single span under the first axles of its train, on a coarse mesh: 0.1 s an evaluation."""
    text = extrados.Bridge.example("passage").text.replace("repeat = 4", "repeat = 1")
    text = re.sub(r"\[\[pier\]\].*?\n\n", "", text, flags=re.DOTALL)
    text = re.sub(r'\[\[sensor\]\]\nname = "pier.*?\n\n', "", text, flags=re.DOTALL)
    text = text.replace("1/4 of span 2", "1/4 of span 1").replace('"abutment-springing"', '"left-springing"')
    text = text.replace('time_step = "0.005 s"', 'time_step = "0.2 s"\nfrom = "1 m"\nto = "12 m"').replace('size = "0.15 m"', 'size = "0.5 m"')
    return extrados.Bridge.parse(text, name="one.toml")


@pytest.mark.skipif(os.environ.get("EXTRADOS_QUICK") == "true", reason="a minute and more: .ci/slow runs it")
def test_emcee_recovers_moduli_from_peaks():
    emcee = pytest.importorskip("emcee")
    truth = numpy.array([14.0, 120.0])
    names = ["crown displacement", "abutment springing displacement", "crown strain", "abutment springing strain"]
    parameters = {"masonry.elastic_modulus": "GPa", "fill.elastic_modulus": "MPa"}
    bounds = numpy.array([[8.0, 24.0], [20.0, 300.0]])
    model = extrados.umbridge.Model(one_span(), parameters, [f"respond.{name}" for name in names])
    with extrados.umbridge.Server(model, port=0) as server:
        remote = umbridge.HTTPModel(server.url, "forward")
        # Peaks as they are, each read with a deviation of two in a hundred: the posterior stands about the truth.
        measured = numpy.array(remote([truth.tolist()])[0])
        deviation = 0.02 * abs(measured)

        def log_probability(values):
            if (values <= bounds[:, 0]).any() or (values >= bounds[:, 1]).any():
                return -numpy.inf
            away = (numpy.array(remote([values.tolist()])[0]) - measured) / deviation
            return -0.5 * float(away @ away)

        random = numpy.random.RandomState(7)
        sampler = emcee.EnsembleSampler(8, 2, log_probability)
        sampler.random_state = random.get_state()
        # From elsewhere, so that the chain has to find it.
        start = numpy.array([16.0, 150.0]) * (1 + 0.03 * random.standard_normal((8, 2)))
        sampler.run_mcmc(start, 50)
        samples = sampler.get_chain(discard=20, flat=True)

        # The posterior by another road: the straight line of the model about the truth, from central differences.
        slopes = []
        for k in range(2):
            step = numpy.zeros(2)
            step[k] = 0.05 * truth[k]
            up, down = (numpy.array(remote([(truth + sign * step).tolist()])[0]) for sign in (1, -1))
            slopes.append((up - down) / (2 * step[k]))
    scaled = numpy.array(slopes).T / deviation[:, None]
    covariance = numpy.linalg.inv(scaled.T @ scaled)
    spread = numpy.sqrt(numpy.diag(covariance))
    low, high = numpy.percentile(samples, [2.5, 97.5], axis=0)
    print(f"emcee: {samples.mean(axis=0)} in {low} to {high}; deviations {samples.std(axis=0)}, by the line {spread}; truth {truth}")
    assert (low < truth).all() and (truth < high).all()
    assert (abs(samples.mean(axis=0) - truth) < spread).all()
    assert (samples.std(axis=0) / spread > 0.5).all() and (samples.std(axis=0) / spread < 2.0).all()
