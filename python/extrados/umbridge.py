"""A bridge as a model of UM-Bridge, the protocol that programs for uncertainty quantification speak.

```
extrados.umbridge.serve(bridge, {"joint.friction_angle": "deg"}, ["collapse.last_stable_load_kn_per_m"])
```

Any client then evaluates it: `umbridge.HTTPModel("http://localhost:4242", "forward")([[35.0]])`. There is one vector of parameters and one of
outputs. Gradients do not exist, and the server says so. Protocol: L. Seelinger et al., "UM-Bridge: Uncertainty quantification and modeling bridge",
Journal of Open Source Software 8 (83), 2023, version 1.0.
"""

from __future__ import annotations

import json
import math
import threading
from collections.abc import Mapping, Sequence
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Any

from .bridge import Bridge
from .errors import Error, argument

__all__ = ["Model", "Server", "serve"]

_ANALYSES = ("collapse", "respond", "sweep")


class Model:
    """A bridge as a function of some of its quantities.

    `parameters` gives the unit of each quantity, by path or by keyword; the empty text is none. An output is the name of an analysis, a dot and the
    name of a number: `collapse.last_stable_load_kn_per_m`, `sweep.load_factor`, or a channel of the passage, whose peak is meant:
    `respond.crown displacement` (in the channel's unit); `.minimum` and `.maximum` after it are its extremes.

    >>> import extrados.umbridge
    >>> bridge = extrados.Bridge.example("tiny")
    >>> model = extrados.umbridge.Model(bridge, {"joint.friction_angle": "deg"}, ["collapse.last_stable_load_kn_per_m"])
    >>> [round(value, 1) for value in model([35.0])]
    [160.2]
    """

    def __init__(self, bridge: Bridge, parameters: Mapping[str, str], outputs: Sequence[str], **options: Any) -> None:
        if not parameters:
            raise argument("parameters = {} cannot be used", 'give quantities with their units: {"joint.friction_angle": "deg"}')
        if isinstance(outputs, str) or not outputs:
            raise argument(f"outputs = {outputs!r} cannot be used", 'give a list such as ["collapse.last_stable_load_kn_per_m"]')
        self.bridge = bridge
        known = {one.keyword: one.path for one in bridge.quantities}
        self.parameters = {known.get(name, name): unit for name, unit in parameters.items()}
        self.outputs = []
        for output in outputs:
            analysis, _, name = str(output).partition(".")
            if analysis not in _ANALYSES or not name:
                raise argument(f"output {output!r} cannot be used", f"write one of {', '.join(_ANALYSES)}, a dot and a number")
            self.outputs.append((analysis, name))
        self.options = options

    def __call__(self, values: Sequence[float], **options: Any) -> list[float]:
        """The outputs for values of the parameters, in their units. What has no answer is an error, and never a number."""
        if len(values) != len(self.parameters):
            raise argument(f"{len(values)} values were given", f"there are {len(self.parameters)} parameters: {', '.join(self.parameters)}")
        edits = {}
        for (path, unit), value in zip(self.parameters.items(), values):
            if isinstance(value, bool) or not isinstance(value, (int, float)) or not math.isfinite(value):
                raise argument(f"{path} = {value!r} cannot be used", "give a number that is finite")
            edits[path] = f"{float(value)!r} {unit}".strip() if unit else float(value)
        edited = self.bridge.with_(edits)
        results: dict[str, Any] = {}
        for analysis, _ in self.outputs:
            if analysis not in results:
                results[analysis] = getattr(edited, analysis)(**{**self.options, **options})
        return [self._number(analysis, name, results[analysis]) for analysis, name in self.outputs]

    @staticmethod
    def _number(analysis: str, name: str, result: Any) -> float:
        whole: Any = result.to_dict()
        if analysis == "respond":
            channels = {one["name"]: one for one in whole["channels"]}
            field = "peak"
            if name not in channels:
                name, _, field = name.rpartition(".")
            if name not in channels or field not in ("peak", "minimum", "maximum"):
                raise argument(f"the passage has no channel {name!r}", f"it has {', '.join(channels)}")
            if whole["status"] != "completed":
                raise argument(f"the passage ended as {whole['status']}", "no peak is known")
            value = channels[name][field]
        else:
            value = (whole.get("governing") or {}).get(name) if analysis == "sweep" else whole.get(name)
        if isinstance(value, bool) or not isinstance(value, (int, float)):
            raise argument(f"{analysis} has no number {name!r}: it ended as {whole['status']}", "leave these values out, or ask for another number")
        return float(value)


class Server:
    """A server that answers until it is closed. As a context manager it closes itself."""

    def __init__(self, model: Model, *, name: str = "forward", host: str = "127.0.0.1", port: int = 4242) -> None:
        self.model, self.name = model, name
        self._server = ThreadingHTTPServer((host, port), _handler(self))
        self._server.daemon_threads = True
        self._thread = threading.Thread(target=self._server.serve_forever, kwargs={"poll_interval": 0.05}, daemon=True)
        self._thread.start()

    @property
    def url(self) -> str:
        """Where it answers."""
        host, port = self._server.server_address[:2]
        return f"http://{host!s}:{port}"

    def close(self) -> None:
        """Ends it."""
        self._server.shutdown()
        self._server.server_close()
        self._thread.join()

    def __enter__(self) -> Server:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def answer(self, path: str, asked: Any) -> tuple[int, dict[str, Any]]:
        """The answer to a request: status and body."""
        if path == "/Info":
            return 200, {"protocolVersion": 1.0, "models": [self.name]}
        if not isinstance(asked, dict):
            return _refused("InvalidInput", "the body of the request is no object of JSON")
        if asked.get("name") != self.name:
            return _refused("ModelNotFound", f"there is no model {asked.get('name')!r}, only {self.name!r}")
        if path == "/ModelInfo":
            return 200, {"support": {"Evaluate": True, "Gradient": False, "ApplyJacobian": False, "ApplyHessian": False}}
        if path == "/InputSizes":
            return 200, {"inputSizes": [len(self.model.parameters)]}
        if path == "/OutputSizes":
            return 200, {"outputSizes": [len(self.model.outputs)]}
        if path != "/Evaluate":
            return _refused("UnsupportedFeature", f"{path[1:]} does not exist: there are evaluations alone")
        given, config = asked.get("input"), asked.get("config") or {}
        if not (isinstance(given, list) and len(given) == 1 and isinstance(given[0], list)):
            return _refused("InvalidInput", "give one vector: [[1.0, 2.0]]")
        try:
            return 200, {"output": [self.model(given[0], **config)]}
        except (Error, TypeError) as error:
            return _refused("InvalidInput", str(error))


def _refused(kind: str, message: str) -> tuple[int, dict[str, Any]]:
    return 400, {"error": {"type": kind, "message": message}}


def _handler(server: Server) -> type[BaseHTTPRequestHandler]:
    class Handler(BaseHTTPRequestHandler):
        protocol_version = "HTTP/1.1"

        def do_GET(self) -> None:
            self._answer(None)

        def do_POST(self) -> None:
            length = int(self.headers.get("Content-Length") or 0)
            try:
                asked = json.loads(self.rfile.read(length) or b"null")
            except ValueError:
                asked = None
            self._answer(asked)

        def _answer(self, asked: Any) -> None:
            status, body = server.answer(self.path, asked)
            text = json.dumps(body).encode()
            self.send_response(status)
            self.send_header("Content-Type", "application/json")
            self.send_header("Content-Length", str(len(text)))
            self.end_headers()
            self.wfile.write(text)

        def log_message(self, format: str, *args: Any) -> None:
            pass

    return Handler


def serve(
    bridge: Bridge,
    parameters: Mapping[str, str],
    outputs: Sequence[str],
    *,
    name: str = "forward",
    host: str = "127.0.0.1",
    port: int = 4242,
    **options: Any,
) -> None:
    """Serves a bridge until Ctrl-C; options go to its analyses. It answers on this machine alone unless `host` says otherwise. `Server` is the
    same without waiting."""
    with Server(Model(bridge, parameters, outputs, **options), name=name, host=host, port=port) as server:
        print(f"{name} of {bridge.name} answers at {server.url}; Ctrl-C ends it")
        try:
            threading.Event().wait()
        except KeyboardInterrupt:
            pass
