"""Which tests are slow, need a browser, fly the paper's experiments or follow the pages: by their place.

A place is a folder, a file, or a test and all its parameters, below `tests`.
"""

BROWSER = (
    "interfaces/lab/test_browser_lab.py",
    "interfaces/replay/test_browser_view.py",
    "interfaces/reproduction/test_pages.py::test_no_page_is_wider_than_the_screen",
    "interfaces/reproduction/test_pages.py::test_pages_can_be_read_in_the_dark",
)
PAPER = ("paper/",)
DOCS = ("test_docs.py", "test_examples.py", "test_readme.py")
#: More than some seconds on one core with kernels compiled.
SLOW = (
    "attack/test_corners.py",
    "attack/test_fuzz.py",
    "batch/test_scenarios.py",
    "campaign/test_cluster.py",
    "campaign/test_running.py",
    "paper/",
    "test_docs.py",
    "test_examples.py",
    "test_mutations.py::test_a_flipped_sign_is_noticed",
    "test_readme.py",
)
