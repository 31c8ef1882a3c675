# make check: every claim of the paper; make test: the tests; both set themselves up in .venv.
PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin

.PHONY: check test lint bench speed notes clean

check: $(VENV)/.core
	$(BIN)/python -m checks check --tier full

test: $(VENV)/.dev
	$(BIN)/python -m pytest -n 2

lint: $(VENV)/.dev
	$(BIN)/python -m ruff check .
	$(BIN)/python -m ruff format --check .
	$(BIN)/python -m mypy

bench: $(VENV)/.dev
	$(BIN)/python -m pytest tests/benchmarks --benchmark-only

# Times the greedy algorithm and puts the table into the README.
speed: $(VENV)/.dev
	$(BIN)/python -m tests.benchmarks.speed_table

# Runs the full suite, keeps its ledger and rebuilds every note from it.
notes: $(VENV)/.core
	$(BIN)/python -m checks check --tier full --json notes/ledger.json
	$(BIN)/python -m checks notes

$(BIN)/pip:
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || \
	  { echo "Python 3.11 or later is needed: make PYTHON=python3.11 check" >&2; exit 1; }
	$(PYTHON) -m venv $(VENV)

$(VENV)/.core: $(BIN)/pip pyproject.toml
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --editable .
	@touch $@

$(VENV)/.dev: $(VENV)/.core
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --editable '.[dev,cluster,figures]'
	@touch $@

clean:
	rm -rf $(VENV) .kminusone build dist .mypy_cache .ruff_cache .pytest_cache .hypothesis
