// The impact lab; its page is springback.interfaces.lab.
export function startLab(element) {
  element.textContent = "";
}
