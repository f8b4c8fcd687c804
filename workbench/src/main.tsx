import { render } from "solid-js/web";
import { App } from "./shell/App";
import "./style/tokens.css";
import "./style/shell.css";

render(() => <App />, document.getElementById("page")!);

if ("serviceWorker" in navigator && import.meta.env.PROD && isSecureContext) {
  void navigator.serviceWorker.register("./sw.js").catch(() => undefined);
}
