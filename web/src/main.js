// Applications of a page, selected by <body data-app="…">.
import "./style.css";
import { startReplay } from "./replay.js";
import { startLab } from "./lab.js";

const apps = { replay: startReplay, lab: startLab };

function start() {
  const app = apps[document.body.dataset.app];
  const data = document.getElementById("data");
  if (app) app(document.getElementById("app"), data ? JSON.parse(data.textContent) : {});
}

if (document.readyState === "loading") document.addEventListener("DOMContentLoaded", start);
else start();
