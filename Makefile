# make        build every dataset and figure into results/, and check them; STUDY=FILE for another study
# make test   lint, types, import contracts and all tests
# make help   the other targets

ifneq ($(words $(CURDIR)),1)
$(error $(CURDIR): Snakemake runs in no folder with a space; move the project)
endif

VENV := .venv
BIN := $(VENV)/bin
LIBRARY := $(VENV)/library
READY := $(VENV)/ready
CHUNKS := $(VENV)/chunks
TOOLS := $(VENV)/tools
COMPILED := $(VENV)/compiled
LOCKS := library.lock results.lock chunks.lock requirements.lock pyproject.toml
CORE := $(shell find src/planar_pushing/mechanics src/planar_pushing/simulation -name '*.py')
PYTHON ?= $(shell for p in python3 python3.14 python3.13 python3.12 python3.11 python; do \
	$$p -c 'import sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null && echo $$p && break; done)

# What the user has for Python elsewhere stays out, byte code is kept, and nothing is written to a home that is not theirs.
unexport PYTHONPATH PYTHONHOME PYTHONDONTWRITEBYTECODE
export PYTHONNOUSERSITE := 1
ifneq ($(shell test -d "$$HOME" && test -w "$$HOME" && echo yes),yes)
export HOME := $(CURDIR)/.snakemake/home
export XDG_CACHE_HOME := $(HOME)/.cache
$(shell mkdir -p "$(XDG_CACHE_HOME)")
endif

.PHONY: all test test-kinds test-slurm test-failures test-browser test-drags lint bench golden images dictionary \
	schemas lock report manual clean help
.DELETE_ON_ERROR:

all: $(COMPILED) $(if $(STUDY),$(CHUNKS))
	$(BIN)/snakemake $(if $(STUDY),--config study=$(STUDY))

test: $(TOOLS) $(COMPILED) lint
	$(BIN)/pytest --numprocesses=auto --dist=worksteal --benchmark-disable

test-kinds: $(TOOLS) $(COMPILED) ## compile what make test runs without the compiler, and test it; some minutes
	EVERY_KIND=1 $(BIN)/pytest --numprocesses=auto tests/simulation/test_any_support.py tests/simulation/test_finger.py

test-slurm: $(TOOLS) $(COMPILED) ## run a study in chunks on a private Slurm (root; slurm-wlm, munge), failures included
	$(BIN)/pytest tests/workflow/slurm.py

test-failures: $(TOOLS) $(COMPILED) ## kill runs, fill disks (root) and build twice; some minutes
	$(BIN)/pytest tests/workflow/failures.py

test-browser: $(TOOLS) $(COMPILED) ## test the explorer in headless Chromium (Debian's chromium); some minutes
	$(BIN)/pytest tests/browser/explorer.py

test-drags: $(TOOLS) $(COMPILED) ## drag 20,000 times in the explorer for memory, latency and pictures a second; ten minutes on an idle machine
	$(BIN)/pytest -s tests/browser/many_drags.py

lint: $(TOOLS)
	$(BIN)/ruff check src tests workflow/scripts paper/manual
	$(BIN)/ruff format --check src tests workflow/scripts paper/manual
	$(BIN)/snakefmt --check --diff Snakefile workflow
	$(BIN)/mypy --num-workers=auto
	$(BIN)/lint-imports --no-cache
	$(BIN)/check-jsonschema --builtin-schema vendor.github-workflows .github/workflows/*.yml

bench: $(TOOLS) $(COMPILED) ## print how fast the mechanics and simulations are, as ratios in one run
	$(BIN)/pytest tests/benchmarks/bench_speed.py --benchmark-columns=min,median,rounds

golden: $(READY) ## compute the golden data anew and print the differences; WRITE=1 stores them
	$(BIN)/python -m planar_pushing.evidence.golden.update $(if $(WRITE),--write)

images: $(READY) ## compare the figures with their stored images; WRITE=1 stores them
	$(BIN)/python -m planar_pushing.figures.images $(if $(WRITE),--write)

dictionary: $(READY) ## write results/README.md from the attributes of the datasets
	$(BIN)/python -m planar_pushing.study.dictionary

schemas: $(READY) ## write workflow/schemas from the models of scene and study files
	$(BIN)/python -m planar_pushing.study.files.schemas

manual: $(TOOLS) $(COMPILED) ## write the manual to results/manual/index.html, from results that it builds where they are missing
	$(BIN)/snakemake manual

report: all ## write results/report.html, Snakemake's report of the last run
	$(BIN)/snakemake --report results/report.html

LOCK := uv pip compile --quiet --universal --python-version 3.11 --fork-strategy fewest --generate-hashes \
	--no-emit-index-url --no-emit-find-links --no-annotate --custom-compile-command "make lock"
# What builds the paper's results, and what a user calls. A study may be in chunks; tests and manual take all.
EXTRAS := workflow cluster figures report golden explore
lock: ## resolve the dependencies anew (needs uv)
	$(LOCK) --upgrade --all-extras --output-file requirements.lock pyproject.toml requirements.build
	$(LOCK) --constraint requirements.lock $(EXTRAS:%=--extra %) --output-file results.lock pyproject.toml requirements.build
	$(LOCK) --constraint requirements.lock $(EXTRAS:%=--extra %) --extra chunks --output-file chunks.lock pyproject.toml requirements.build
	$(LOCK) --constraint requirements.lock --output-file library.lock pyproject.toml requirements.build

clean: ## remove everything that was generated
	rm -rf $(VENV) .snakemake .pytest_cache .mypy_cache .ruff_cache .hypothesis .import_linter_cache build dist
	find src tests -name __pycache__ -prune -exec rm -rf {} +
	find results -mindepth 1 -not -name README.md -delete

help:
	@grep -hE '^(# make|[a-z-]+:.*## )' $(MAKEFILE_LIST) | sed -E 's/^# //; s/^([a-z-]+):.*## /make \1\t/' | expand -t 20

ifndef ALONE
# One at a time: who has waited finds it made. The core is compiled while the packages are installed.
WANTED = $(READY) $(COMPILED) $(filter $(CHUNKS) $(TOOLS),$@)
$(READY) $(CHUNKS) $(TOOLS): $(LOCKS)
$(COMPILED): $(CORE) | $(READY)
$(READY) $(CHUNKS) $(TOOLS) $(COMPILED):
	@test -n "$(PYTHON)" || { echo "make: needs Python 3.11 or newer on the path; or set PYTHON=/path/to/python" >&2; exit 1; }
	@$(MAKE) --question --no-print-directory ALONE=1 $(WANTED) || \
		$(PYTHON) workflow/alone.py $(MAKE) --no-print-directory --jobs=2 ALONE=1 PYTHON=$(PYTHON) $(WANTED)
else
# Without byte code: Python writes it for what is used. A lock file names all that is needed.
PIP := $(BIN)/python -m pip install --disable-pip-version-check --no-compile --no-deps

$(LIBRARY): $(LOCKS)
	@echo "Setting up $(VENV) with $(PYTHON)"
	rm -rf $(VENV)
	$(PYTHON) -m venv $(VENV)
	$(PIP) --require-hashes -r library.lock
	$(PIP) --quiet --no-build-isolation --editable .
	@touch $@

$(READY): $(LIBRARY)
	$(PIP) --require-hashes -r results.lock
	@touch $@

$(CHUNKS): $(READY)
	$(PIP) --require-hashes -r chunks.lock
	@touch $@

$(TOOLS): $(READY)
	$(PIP) --require-hashes -r requirements.lock
	@touch $@

$(COMPILED): $(LIBRARY) $(CORE)
	$(BIN)/planar-pushing compile
	@touch $@
endif
