# `make run` and `make test` build their environment from nothing but Python >= 3.11 with `venv`.
# The interpreter is `make PYTHON=/path/to/python3.12 ...`, the environment's folder `make VENV=...`.

PYTHON ?= $(shell command -v python3.11 || command -v python3)
VENV ?= .venv
OUT ?= out

BIN := $(VENV)/bin
PIP := $(BIN)/python -m pip install --quiet --disable-pip-version-check --only-binary :all: -c constraints.txt
RUN_STAMP := $(VENV)/.stamp-run
DEV_STAMP := $(VENV)/.stamp-dev
BENCH_STAMP := $(VENV)/.stamp-bench
SOURCES := acausal tests benchmarks docs

.DEFAULT_GOAL := help
.NOTPARALLEL:
.DELETE_ON_ERROR:
.PHONY: help run test lint types docs unit bench fix lock clean

help: ## Show what can be made
	@sed -n 's/^\([a-z]*\):.*## \(.*\)/  make \1|\2/p' $(firstword $(MAKEFILE_LIST)) | awk -F'|' '{ printf "%-14s %s\n", $$1, $$2 }'

run: $(RUN_STAMP) ## Compile, simulate and plot the two demonstration systems into out/
	$(BIN)/python -m acausal.demo --out $(OUT)

test: lint types docs unit ## Everything a change has to pass

lint: $(DEV_STAMP) ## Style and formatting
	$(BIN)/ruff check $(SOURCES)
	$(BIN)/ruff format --check $(SOURCES)

types: $(DEV_STAMP) ## Types, strictly
	$(BIN)/pyright --pythonpath $(BIN)/python

docs: $(DEV_STAMP) ## The documentation, into docs/_build/html; a warning is an error
	$(BIN)/python -m sphinx -q -W --keep-going -E -b html docs docs/_build/html

unit: $(DEV_STAMP) ## The tests, with coverage
	$(BIN)/python -m pytest --cov --cov-report=term

bench: $(BENCH_STAMP) ## The benchmarks (see benchmarks/README.md)
	$(BIN)/python -m benchmarks --out $(OUT)

fix: $(DEV_STAMP) ## Let ruff repair and format what it can
	$(BIN)/ruff check --fix $(SOURCES)
	$(BIN)/ruff format $(SOURCES)

lock: ## Resolve every dependency anew and rewrite constraints.txt
	$(PYTHON) -m venv --clear $(VENV)-lock
	$(VENV)-lock/bin/python -m pip install --quiet --disable-pip-version-check --only-binary :all: hatchling
	$(VENV)-lock/bin/python -m pip install --quiet --disable-pip-version-check --only-binary :all: \
		--no-build-isolation '.[dev,docs,notebook,bench]'
	{ echo '# Written by `make lock` on Python 3.11: the versions that `make` installs.'; \
	  $(VENV)-lock/bin/python -m pip list --format=freeze --exclude acausal --exclude pip --exclude setuptools; } > constraints.txt
	rm -rf $(VENV)-lock

clean: ## Remove everything that make made
	rm -rf $(VENV) $(VENV)-lock $(OUT) dist build docs/_build htmlcov .coverage .pytest_cache .ruff_cache .hypothesis
	find $(SOURCES) -name __pycache__ -type d -prune -exec rm -rf {} +

$(RUN_STAMP): pyproject.toml constraints.txt
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || \
		{ echo 'acausal needs Python 3.11 or newer: make PYTHON=/path/to/python3.11 ...' >&2; exit 1; }
	@$(PYTHON) -c 'import ensurepip, venv' || \
		{ echo 'This Python has no venv module. On Debian: apt install python3-venv' >&2; exit 1; }
	$(PYTHON) -m venv --clear $(VENV)
	$(PIP) hatchling
	$(PIP) --no-build-isolation -e .
	@touch $@

$(DEV_STAMP): $(RUN_STAMP)
	$(PIP) --no-build-isolation -e '.[dev,docs]'
	@touch $@

$(BENCH_STAMP): $(RUN_STAMP)
	$(PIP) --no-build-isolation -e '.[bench]'
	@touch $@
