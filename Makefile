# make        build all datasets and figures in results/ and check them; STUDY=FILE selects another study
# make test   check style, types and import contracts, and run the tests that every change must pass
# make help   list the other targets

VENV := .venv
BIN := $(VENV)/bin
INSTALLED := $(VENV)/installed
CORE := src/planar_pushing/core/_compiled.abi3.so
PYTHON ?= $(shell for p in python3 python3.14 python3.13 python3.12 python3.11 python; do \
	$$p -E -c 'import sys; sys.exit(not (3, 11) <= sys.version_info < (3, 15))' 2>/dev/null && echo $$p && break; done)

ifneq ($(MAKECMDGOALS),help)
ifneq ($(words $(CURDIR)),1)
$(error $(CURDIR): Snakemake cannot run in a path with a space; move the project)
endif
ifneq ($(shell test -w . && echo yes),yes)
$(error $(CURDIR): cannot be written; make needs a folder that you can write to)
endif
ifneq ($(shell $(PYTHON) -E -c 'import sys; print((3, 11) <= sys.version_info < (3, 15))' 2>/dev/null),True)
$(error Python 3.11 to 3.14 is required, but $(or $(PYTHON),none) was found; set PYTHON=/path/to/python)
endif
endif

# Ignore the user's settings for other projects, and replace a home or cache folder that is not writable.
unexport PYTHONPATH PYTHONHOME PYTHONDONTWRITEBYTECODE MPLBACKEND SNAKEMAKE_PROFILE VIRTUAL_ENV
export PYTHONNOUSERSITE := 1
CACHE_HOME := $(or $(XDG_CACHE_HOME),$(HOME)/.cache)
ifneq ($(shell test -w "$(HOME)" && mkdir -p "$(CACHE_HOME)" 2>/dev/null && test -w "$(CACHE_HOME)" && echo yes),yes)
export HOME := $(CURDIR)/.snakemake/home
export XDG_CACHE_HOME := $(HOME)/.cache
$(shell mkdir -p "$(XDG_CACHE_HOME)")
endif

.PHONY: all test test-all test-processors test-slurm test-drags mutants lint coverage bench golden images front pages dictionary lock report jobs-report manual clean help
.DELETE_ON_ERROR:

# One make at a time. The operating system releases the lock when its process ends, even if it is killed.
# Snakemake replaces the shell, so that a SIGTERM sent to make, which passes it on, lets it end after its running jobs.
LOCK := exec 9>>.making; $(PYTHON) -E -c 'import fcntl; fcntl.flock(9, fcntl.LOCK_EX | fcntl.LOCK_NB)' 2>/dev/null || { \
	echo "Another make is running in this folder; waiting for it"; $(PYTHON) -E -c 'import fcntl; fcntl.flock(9, fcntl.LOCK_EX)'; }

all: $(CORE)
	@$(LOCK); exec $(BIN)/snakemake $(if $(STUDY),--config study=$(STUDY))
	@$(LOCK); $(BIN)/python -m pulling_by_pushing.report.closing $(STUDY)

# An environment is valid only for its folder and the locked packages.
STATE := $(CURDIR) $(shell cat requirements.lock pyproject.toml | cksum)
ifneq ($(shell cat $(INSTALLED) 2>/dev/null),$(STATE))
.PHONY: $(INSTALLED)
endif
UV := $(BIN)/uv pip install --quiet --python $(BIN)/python --no-deps
$(INSTALLED):
	@$(LOCK); test "$$(cat $@ 2>/dev/null)" = "$(STATE)" || { \
	echo "Installing the locked packages into $(VENV), with $(PYTHON)" && \
	$(PYTHON) -m venv --clear $(VENV) && \
	sed -n '/^uv==/,/[^\\]$$/p' requirements.lock > $(VENV)/uv.txt && \
	$(BIN)/python -m pip install -qq --disable-pip-version-check --no-deps --require-hashes -r $(VENV)/uv.txt && \
	$(UV) --require-hashes -r requirements.lock && $(UV) --no-build-isolation --editable . && \
	echo "$(STATE)" > $@; }

# Without a compiler there is no such file, and each make says so.
$(CORE): $(shell find src/planar_pushing/core joiner -name '*.py') | $(INSTALLED)
	@$(LOCK); $(BIN)/python -m joiner.hook

PYTEST := $(BIN)/pytest --numprocesses=auto --dist=worksteal --benchmark-disable
test: lint $(CORE)
	$(PYTEST)

test-all: $(CORE) ## run the slow tests: workflow, manual, processors, failures, browser, Slurm; half an hour
	$(PYTEST) -m slow
	$(BIN)/pytest -m alone
	$(PROCESSORS)

PROCESSORS = @$(LOCK); $(BIN)/python -m pulling_by_pushing.evidence.golden.processors
test-processors: $(CORE) ## build and check the golden data as on older processors, and with all features of this one
	$(PROCESSORS)

test-slurm: $(CORE) ## run a study in chunks on a private Slurm, including failures (needs root, slurm-wlm, munge)
	$(BIN)/pytest -m alone tests/paper/workflow/test_slurm.py

test-drags: $(CORE) ## drag parts of the explorer 20,000 times in Chromium; measure frame rate, latency and memory
	$(BIN)/pytest -s tests/library/browser/many_drags.py

FOLDER ?= build/mutants
mutants: $(CORE) ## change the core in 107 places, one at a time, and list those that its fast tests miss; an hour
	$(BIN)/python tests/mutants $(FOLDER)

lint: $(INSTALLED)
	$(BIN)/ruff check src tests workflow/scripts paper/manual joiner
	$(BIN)/ruff format --check src tests workflow/scripts paper/manual joiner
	$(BIN)/snakefmt --check --diff Snakefile workflow
	$(BIN)/mypy --num-workers=auto
	$(BIN)/lint-imports --no-cache
	$(BIN)/check-jsonschema --builtin-schema vendor.github-workflows .github/workflows/*.yml

coverage: $(INSTALLED) $(CORE) ## print the lines of the core that its test of bits does not run as plain Python
	$(BIN)/coverage run -m pytest -p no:cacheprovider -q tests/library/core/test_same_bits.py
	$(BIN)/coverage report

bench: $(CORE) ## print the speed of the mechanics and the simulations, as ratios within one run
	$(BIN)/pytest tests/benchmarks/bench_speed.py --benchmark-columns=min,median,rounds

golden: $(CORE) ## recompute the golden data of the results and print the differences; WRITE=1 stores them
	@$(LOCK); exec $(BIN)/snakemake data accuracy
	$(BIN)/python -m pulling_by_pushing.evidence.golden.update $(if $(WRITE),--write)

images: $(CORE) ## compare the figures with their stored images; WRITE=1 stores them
	$(BIN)/python -m pulling_by_pushing.figures.images $(if $(WRITE),--write)

front: $(CORE) ## compare the pictures of README with the stored ones; WRITE=1 stores them
	$(BIN)/python -m pulling_by_pushing.figures.front $(if $(WRITE),--write)

pages: $(CORE) ## compare the pages in docs with those of the manual, as of the last results; WRITE=1 stores them
	$(BIN)/python -m pulling_by_pushing.figures.pages $(if $(WRITE),--write)

dictionary: $(INSTALLED) ## write results/README.md from the attributes of the datasets
	$(BIN)/python -m pulling_by_pushing.study.dictionary

manual: $(CORE) ## write the manual to results/manual/index.html; missing results are built first
	@$(LOCK); exec $(BIN)/snakemake manual

report: $(CORE) ## write the report to results/paper.pdf; missing results are built first
	@$(LOCK); exec $(BIN)/snakemake paper
	@echo "results/paper.pdf"

jobs-report: all ## write results/report.html, Snakemake's report on the jobs of the last run
	@$(LOCK); exec $(BIN)/snakemake --report results/report.html

lock: $(INSTALLED) ## update requirements.lock to the newest versions of the dependencies
	$(BIN)/uv pip compile --quiet --universal --python-version 3.11 --fork-strategy fewest --generate-hashes \
		--no-emit-index-url --no-emit-find-links --no-annotate --custom-compile-command "make lock" \
		--upgrade --all-extras --output-file requirements.lock pyproject.toml requirements.build

clean: ## remove all generated files
	rm -rf $(VENV) .making .snakemake .pytest_cache .mypy_cache .ruff_cache .hypothesis .import_linter_cache .coverage build dist
	find src tests joiner -name __pycache__ -prune -exec rm -rf {} +
	rm -f src/planar_pushing/core/_compiled.* src/planar_pushing/core/._compiled.*
	find results -mindepth 1 -not -name README.md -delete

help:
	@grep -hE '^(# make|[a-z-]+:.*## )' $(MAKEFILE_LIST) | \
		sed -E 's/^# (make[ a-z]*[a-z]|make)  +/\1\t/; s/^([a-z-]+):.*## /make \1\t/' | expand -t 22
