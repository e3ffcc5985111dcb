# `make run` reproduces the paper into ./reproduction; `make test` runs all checks.
# Both need python3 and make only: they make their own environment in .venv.
BIN = .venv/bin
OUT ?= reproduction

# Byte code is kept, whatever the shell says: without it each program takes a second more to start.
export PYTHONDONTWRITEBYTECODE =

.PHONY: run test quick rare lint types layers pytest mutations geometry attack fuzz docs bench wheel lock web clean

run:
	@tools/environment all
	@echo springback doctor --compile, beside the reproduction
	@$(BIN)/springback doctor --compile --quiet & ahead=$$!; \
	trap 'kill $$ahead 2>/dev/null; exit 130' INT TERM; \
	$(BIN)/springback reproduce --out $(OUT) --force || { kill $$ahead; exit 1; }; \
	echo "the report is ready; rarer kinds of flight still compile, which may be interrupted"; \
	wait $$ahead

test:
	@tools/environment dev
	@$(MAKE) --no-print-directory lint types layers pytest

lint:
	$(BIN)/ruff format --check .
	$(BIN)/ruff check .

types:
	$(BIN)/mypy

layers:
	$(BIN)/lint-imports

# A killed worker ends the run: after a restart, files that it held are never finished.
PARALLEL = -n 2 --dist loadfile --no-loadscope-reorder --max-worker-restart=0 --instafail --durations 30

# In three runs: a worker holds every kernel that it compiled or read; in one, two of them hold 18 GB
# after three quarters of all tests.
PHYSICS = tests/contact tests/dynamics tests/vehicle

pytest:
	$(BIN)/pytest $(PARALLEL) -m "not rare" tests/simulation
	$(BIN)/pytest $(PARALLEL) -m "not rare" $(PHYSICS)
	$(BIN)/pytest $(PARALLEL) -m "not rare" $(addprefix --ignore=,tests/simulation $(PHYSICS))

# What `make test` leaves out: kinds of flight that compile for half a minute or more each, where
# others of their table are flown.  Before a release: an hour.
rare:
	@tools/environment dev
	$(BIN)/pytest $(PARALLEL) -m rare tests/simulation
	$(BIN)/pytest $(PARALLEL) -m rare --ignore=tests/simulation

# Two minutes, kernels compiled: all but slow tests and those in a browser.
quick:
	@tools/environment dev
	$(BIN)/pytest $(PARALLEL) -m "not slow and not browser and not rare"

# Flip one sign of the physics at a time; MUTATIONS=damper: those whose name has it.
mutations:
	@tools/environment dev
	PYTHONPATH=src:tests $(BIN)/python tests/oracles/mutations.py $(MUTATIONS)

# Gaps and normals of all parts and shapes beside a slow oracle: a table (docs/validation.md); then
# of hulls of every kind, and against grids: some three quarters of an hour; POSES=500: less.
POSES ?= 10000
geometry:
	@tools/environment dev
	cd tests && ../$(BIN)/python -m oracles.geometry --poses $(POSES) $(ONLY)
	POSES=$(POSES) $(BIN)/pytest -q -n 2 --timeout 0 -k "very_many_poses or lowest_point_of_a_form" \
		tests/contact/test_hull_distances.py tests/contact/test_hull_forms.py

# Damage, foreign SQL, broken caches, Ctrl-C and kill -9 at any instant, and `make fuzz`: a table.
attack:
	@tools/environment dev
	cd tests && ../$(BIN)/python -m attack $(ATTACK)

# Untrusted inputs, some 10^5 an hour; every finding is printed with its seed.
CASES ?= 100000
SEED ?= 1
fuzz:
	@tools/environment dev
	PYTHONPATH=tests $(BIN)/python -m attack.fuzz --cases $(CASES) --seed $(SEED)

docs:
	@tools/environment docs
	$(BIN)/python -m sphinx -W --keep-going -q -b html docs docs/_build/html
	@echo "open docs/_build/html/index.html"

bench:
	@tools/environment dev
	$(BIN)/python -m benchmarks.run

# A wheel with compiled kernels for this platform and version of Python, into dist: some minutes;
# VEHICLES="navi morphy": with those of flights of these, too, some five minutes each and level.
wheel:
	@tools/environment dev
	$(BIN)/python tools/wheel.py --out dist $(addprefix --vehicle ,$(VEHICLES))

lock:
	uv lock
	for extra in all dev docs; do \
		uv export --quiet --locked --extra $$extra --no-emit-project --no-annotate \
			--output-file tools/locked/$$extra.txt || exit 1; \
	done
	for tools in build:hatchling,editables uv:uv; do \
		echo $${tools#*:} | tr , '\n' | uv pip compile --quiet --universal --python-version 3.11 \
			--generate-hashes --no-annotate --output-file tools/locked/$${tools%:*}.txt - || exit 1; \
	done

# The script of the pages, after a change under web/; needs node, which nothing else does.
web:
	cd web && npm ci --ignore-scripts --no-audit --no-fund && node build.mjs

clean:
	rm -rf .venv $(OUT) docs/_build docs/api/modules/generated
