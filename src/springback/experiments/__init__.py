"""Ask a question: scenarios, their results, and the experiments of the paper."""
