// Requests flights from the server one at a time; of those requested meanwhile only the last.

/** Time after which a request is repeated while kernels compile, or too many wait [ms]. */
const AGAIN = 700;

/**
 * @param page identifier of this page's requests for the server
 * @param on {answered, refused, waits, gone}
 */
export function createQueue(page, on) {
  let wanted = null;
  let busy = false;
  let timer = 0;

  function ask(query, how) {
    clearTimeout(timer);
    wanted = { query, how };
    if (!busy) next();
  }

  async function next() {
    const { query, how } = wanted;
    wanted = null;
    busy = true;
    try {
      await fetchFlight(query, how);
    } catch {
      if (!wanted) on.gone();
    }
    busy = false;
    if (wanted) next();
  }

  async function fetchFlight(query, how) {
    const response = await fetch(`flight?${query}`, { headers: { "x-lab-page": page } });
    const found = await response.json();
    if (response.ok) {
      // While a slider moves every answer is drawn; a newer one follows right after.
      on.answered(found, { ...how, older: wanted !== null });
    } else if (response.status === 503) {
      if (wanted) return; // what was chosen since then is asked for next
      if (found.preparing) on.waits(found.preparing);
      timer = setTimeout(() => ask(query, { ...how, since: performance.now() }), AGAIN);
    } else if (!found.overtaken && !wanted) {
      on.refused(found.errors, how);
    }
  }
  return { ask };
}
