// Asks the server for flights: one at a time, and of what was asked meanwhile only the last.

/** Ask again after so long where kernels are being compiled, or too many wait [ms]. */
const AGAIN = 700;

/**
 * @param page a word by which the server knows this page's requests
 * @param on {answered, refused, waits, gone}
 */
export function createDesk(page, on) {
  let wanted = null;
  let busy = false;
  let timer = 0;

  function ask(query, asked) {
    clearTimeout(timer);
    wanted = { query, asked };
    if (!busy) next();
  }

  async function next() {
    const { query, asked } = wanted;
    wanted = null;
    busy = true;
    try {
      await told(query, asked);
    } catch {
      if (!wanted) on.gone();
    }
    busy = false;
    if (wanted) next();
  }

  async function told(query, asked) {
    const response = await fetch(`flight?${query}`, { headers: { "x-lab-page": page } });
    const found = await response.json();
    if (response.ok) {
      // While a slider moves every answer is drawn; a newer wish comes right after.
      on.answered(found, asked);
    } else if (response.status === 503) {
      if (found.preparing) on.waits(found.preparing);
      timer = setTimeout(() => ask(query, { ...asked, since: performance.now() }), AGAIN);
    } else if (!found.overtaken && !wanted) {
      on.refused(found.errors, asked);
    }
  }
  return { ask };
}
