// Order of search results: chapters and how-to pages first, then reference, then attributes.
var Scorer = {
  score: ([docname, title, anchor, descr, score]) => {
    const weights = [
      [/^story\//, 34],
      [/^(start|howto\/)/, 32],
      [/^(commands|coming_from)/, 28],
      [/^(paper\/|glossary|benchmarks)/, 15],
      [/^(changelog|decisions\/)/, -5],
      [/^api\//, -10],
    ];
    const found = weights.find(([pages]) => pages.test(docname));
    return score + (found ? found[1] : 0);
  },
  objNameMatch: 11,
  objPartialMatch: 2,
  objPrio: { 0: 5, 1: 2, 2: -5 },
  objPrioDefault: 0,
  title: 15,
  partialTitle: 7,
  term: 5,
  partialTerm: 2,
};
