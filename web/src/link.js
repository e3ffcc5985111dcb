// The view in the fragment of the address: #t=1.234&camera=impact&plots=Velocity;x,est_x

/** Time after the last change at which the address is renewed [ms]. */
const PAUSE = 250;

/**
 * Keep a state in the address.
 *
 * @param read returns the state as an object of texts; empty ones are left out
 * @param apply shows what a link asks for, given as such an object
 */
export function createLink({ read, apply }) {
  let waiting = 0;
  let written = location.hash;

  const text = () => {
    const entries = Object.entries(read()).filter(([, value]) => value !== "");
    return `#${new URLSearchParams(entries)}`.replace(/%2C/g, ",").replace(/%3B/g, ";");
  };

  function write() {
    clearTimeout(waiting);
    written = text();
    try {
      history.replaceState(null, "", written);
    } catch {
      // a page in a sandbox has no address of its own
    }
  }

  addEventListener("hashchange", () => {
    if (location.hash !== written) follow();
  });

  function follow() {
    apply(Object.fromEntries(new URLSearchParams(location.hash.slice(1))));
  }

  return {
    follow,
    /** Renew the address soon. */
    renew() {
      clearTimeout(waiting);
      waiting = setTimeout(write, PAUSE);
    },
    /** The whole address of the present view. */
    address() {
      write();
      return location.href.replace(/#.*/, "") + written;
    },
  };
}
