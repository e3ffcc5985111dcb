// Pictures and films of the view, as the browser shows it.
import { create } from "./elements.js";

const KINDS = ["video/webm;codecs=vp9", "video/webm;codecs=vp8", "video/webm", "video/mp4"];
const RATE = 30;

/** Hand a file to the user. */
function save(blob, name) {
  const link = create("a", { href: URL.createObjectURL(blob), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

/** Text of an element of the page, where it is, with its background. */
function paint(pen, element, origin, swatch = null) {
  const box = element.getBoundingClientRect();
  const style = getComputedStyle(element);
  if (!box.width) return;
  const [x, y] = [box.left - origin.left, box.top - origin.top];
  pen.fillStyle = style.backgroundColor;
  pen.fillRect(x, y, box.width, box.height);
  let from = x + parseFloat(style.paddingLeft);
  if (swatch && parseFloat(swatch.width) > 0) {
    const height = parseFloat(swatch.height);
    pen.fillStyle = swatch.backgroundColor;
    pen.fillRect(from, y + (box.height - height) / 2, parseFloat(swatch.width), height);
    from += parseFloat(swatch.width) + parseFloat(swatch.marginRight);
  }
  pen.font = `${style.fontWeight} ${style.fontSize} ${style.fontFamily}`;
  pen.textBaseline = "middle";
  pen.fillStyle = style.color;
  pen.fillText(element.textContent, from, y + box.height / 2 + 1, x + box.width - from);
}

/**
 * @param parts {scene, stage, player}
 * @param parts.name of the files, without an ending
 * @param parts.say called with a sentence for the user
 * @param parts.onRecording called with true when a film begins and false when it has ended
 */
export function createCapture({ scene, stage, player, name, say, onRecording = () => {} }) {
  const clock = create("div", { class: "stage-clock", "aria-hidden": "true" });
  stage.append(clock);
  let recorder = null;
  let frame = null;

  function blank() {
    const ratio = Math.min(devicePixelRatio || 1, 2);
    const canvas = create("canvas", { width: 2 * Math.round((stage.clientWidth * ratio) / 2), height: 2 * Math.round((stage.clientHeight * ratio) / 2) });
    return { canvas, pen: canvas.getContext("2d"), ratio };
  }

  /** The view, its numbers, its legend and its time on a canvas. */
  function compose({ canvas, pen, ratio }, picture) {
    clock.textContent = `${scene.pose().t.toFixed(4)} s`;
    const origin = stage.getBoundingClientRect();
    pen.setTransform(1, 0, 0, 1, 0, 0);
    pen.drawImage(picture, 0, 0, canvas.width, canvas.height);
    pen.scale(ratio, ratio);
    const legend = stage.querySelector(".scene-legend");
    const box = legend.getBoundingClientRect();
    pen.fillStyle = getComputedStyle(legend).backgroundColor;
    pen.fillRect(box.left - origin.left, box.top - origin.top, box.width, box.height);
    for (const key of legend.children) paint(pen, key, origin, getComputedStyle(key, "::before"));
    for (const label of stage.querySelectorAll(".force-labels span:not([hidden])")) paint(pen, label, origin);
    paint(pen, clock, origin);
  }

  /** Save the present view as a PNG. */
  function picture() {
    const now = scene.canvas();
    if (!now) return say("There is no picture without WebGL.");
    const sheet = blank();
    compose(sheet, now);
    sheet.canvas.toBlob((blob) => {
      save(blob, `${name}-${scene.pose().t.toFixed(4)}s.png`);
      say("The picture is among your downloads.");
    });
  }

  /** Play and record from here to the end of the flight, or until called again. */
  function film() {
    if (recorder) return recorder.stop();
    const kind = window.MediaRecorder && KINDS.find((one) => MediaRecorder.isTypeSupported(one));
    if (!kind || !scene.canvas() || !HTMLCanvasElement.prototype.captureStream) {
      return say("This browser cannot record films. The command springback animate RESULT --out film.gif makes one, or film.mp4.");
    }
    frame = blank();
    compose(frame, scene.canvas());
    const parts = [];
    recorder = new MediaRecorder(frame.canvas.captureStream(RATE), { mimeType: kind, videoBitsPerSecond: 12e6 });
    recorder.ondataavailable = (event) => parts.push(event.data);
    recorder.onstop = () => {
      [recorder, frame] = [null, null];
      player.pause();
      onRecording(false);
      save(new Blob(parts, { type: kind }), `${name}.${kind.includes("mp4") ? "mp4" : "webm"}`);
      say("The film is among your downloads. springback animate makes one without dropped frames.");
    };
    recorder.start();
    onRecording(true);
    player.play();
  }

  return {
    picture,
    film,
    /** After each drawing of the scene. */
    drawn() {
      if (frame) compose(frame, scene.canvas(false));
    },
    /** When the player rests. */
    rested() {
      if (recorder?.state === "recording" && !player.playing) recorder.stop();
    },
    get recording() {
      return Boolean(recorder);
    },
  };
}
