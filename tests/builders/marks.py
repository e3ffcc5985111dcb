"""Which tests are slow, need a browser, fly the paper's experiments or follow the pages: by their place.

A place is a folder, a file, or a test and all its parameters, below `tests`.
"""

BROWSER = (
    "interfaces/lab/test_browser_lab.py",
    "interfaces/reports/test_browser_summary.py",
    "interfaces/replay/test_browser_signals.py",
    "interfaces/replay/test_browser_view.py",
    "interfaces/reproduction/test_pages.py::test_no_page_is_wider_than_the_screen",
    "interfaces/reproduction/test_pages.py::test_pages_can_be_read_in_the_dark",
)
PAPER = ("paper/",)
DOCS = ("test_docs.py", "test_examples.py", "test_readme.py")
#: Many flights, whole programs, own kernels compiled, or many figures: more than some seconds of one core.
SLOW = (
    "attack/test_bounds.py",
    "attack/test_corners.py",
    "attack/test_fuzz.py",
    "batch/test_scenarios.py",
    "batch/test_variety.py::test_every_number_is_traced",
    "campaign/test_cluster.py",
    "campaign/test_envelope.py",
    "campaign/test_measures.py",
    "campaign/test_own_code.py",
    "campaign/test_running.py",
    "campaign/test_strangers.py",
    "contact/test_obstacles.py::test_own_obstacle_compiles_and_gives_the_same_bits",
    "contact/test_obstacles.py::test_own_obstacle_stays_out_of_the_kernels_on_disk",
    "contact/test_rings.py::test_a_flight_into_a_thin_pole_closes_its_ledger",
    "contact/test_rounding.py",
    "dynamics/test_conservation.py::test_impulses_never_add_energy",
    "dynamics/test_engines.py",
    "dynamics/test_lagrangian.py",
    "interfaces/animation/",
    "interfaces/cli/",
    "interfaces/figures/",
    "interfaces/lab/",
    "interfaces/output/",
    "interfaces/replay/",
    "interfaces/reproduction/",
    "interfaces/web/test_server.py::test_slow_answers_and_later_requests_have_their_time",
    "kernels/test_kernel_cache.py",
    "paper/",
    "recovery/test_pilot.py",
    "results/test_flight.py::test_a_misspelt_measure_is_an_error_of_mypy",
    "results/test_impact_estimation.py",
    "results/test_recovery_measures.py",
    "rivals/",
    "scenario/test_bad_input_flight.py",
    "scenario/test_thrusts.py::test_it_is_compiled_to_the_same_bits",
    "scenario/test_user_pilots.py",
    "scenario/test_user_sensing.py",
    "sensing/test_estimation.py",
    "sensing/test_kalman.py::test_agrees_with_dense_matrices",
    "sensing/test_sensors.py::test_plain_python_and_compiled_are_twins",
    "simulation/test_combinations.py",
    "simulation/test_convergence.py",
    "simulation/test_gpu.py",
    "simulation/test_guided.py",
    "simulation/test_peaks.py::test_a_smooth_peak_is_found_far_within_the_error_of_its_samples",
    "simulation/test_rotor_loop.py",
    "simulation/test_shapes_fly.py",
    "simulation/test_twins.py",
    "studies/",
    "test_docs.py",
    "test_environment.py",
    "test_examples.py",
    "test_mutations.py::test_a_flipped_sign_is_noticed",
    "test_readme.py",
)
#: Longest files first, so that no worker is left with one at the end.
FIRST = ("test_readme.py", "test_examples.py")
