import { render } from "solid-js/web";
import { liveEngine } from "./model/live";
import { App } from "./shell/App";
import "./style/tokens.css";
import "./style/shell.css";

render(() => <App />, document.getElementById("page")!);

// The test of a worker that dies asks for it by this event; the engine panics as a defect would make it.
addEventListener("extrados-test-fail", () => void liveEngine.call("fail", { text: "asked for by a test" }).catch(() => undefined));

if ("serviceWorker" in navigator && import.meta.env.PROD && isSecureContext) {
  void navigator.serviceWorker.register("./sw.js").catch(() => undefined);
}
