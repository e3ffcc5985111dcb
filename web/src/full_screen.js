// Full screen: a button that fills the screen with an element, and leaves it again.
import { create, icon } from "./elements.js";

/**
 * @param filling returns the element that fills the screen
 * @param refused called if the browser does not allow it
 * @returns {button, toggle}; the button is hidden where the browser has no full screen
 */
export function createFullScreen(filling, refused) {
  const toggle = () => (document.fullscreenElement ? document.exitFullscreen() : filling().requestFullscreen().catch(refused));
  const button = create("button", { type: "button", class: "tool tool-full", hidden: !document.fullscreenEnabled, onclick: toggle }, icon("full"));
  function tell() {
    const label = document.fullscreenElement ? "Leave full screen" : "Full screen";
    button.title = `${label} (F)`;
    button.setAttribute("aria-label", label);
  }
  document.addEventListener("fullscreenchange", tell);
  tell();
  return { button, toggle };
}
