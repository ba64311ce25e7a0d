# make lab: open the course.  make test: prove that it works.  Both set up all they need in .venv: start.py, for every system.
PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
JOBS ?= 3

.PHONY: lab test check bench soak class hub conformance docs web notebooks wheel windows clean

$(VENV)/.lab: pyproject.toml requirements.lock
	$(PYTHON) start.py setup

$(VENV)/.test: pyproject.toml requirements.lock
	$(PYTHON) start.py setup test

lab:
	$(PYTHON) start.py lab

test:
	JOBS=$(JOBS) $(PYTHON) start.py test

notebooks: $(VENV)/.test
	$(BIN)/python -m tests.notebooks.store

check: $(VENV)/.test
	$(BIN)/ruff check .
	$(BIN)/mypy
	$(BIN)/python -m pytest -n $(JOBS) --dist loadfile -m "not slow" tests/core tests/rcl tests/processes tests/interfaces tests/launch tests/cli

bench: $(VENV)/.test
	$(BIN)/python -m tests.benchmarks

soak: $(VENV)/.test
	$(BIN)/python -m tests.net.soak 30

class: $(VENV)/.test
	$(BIN)/python -m tests.grade

hub: $(VENV)/.test
	$(BIN)/python -m pip install -q --disable-pip-version-check -c requirements.lock -e ".[hub]"
	npm install --no-fund --no-audit --prefix $(VENV) configurable-http-proxy
	COURSEKIT_HUB_STUDENTS=$${COURSEKIT_HUB_STUDENTS:-20} COURSEKIT_HUB_CHAPTERS="$${COURSEKIT_HUB_CHAPTERS:-01 08}" \
		$(BIN)/python -m pytest -rs -s tests/hub

windows: $(VENV)/.test
	$(BIN)/python -m tests.windows

wheel: $(VENV)/.lab
	$(BIN)/python -m pip wheel -q --disable-pip-version-check --no-deps -w dist .
	@ls dist/*.whl

conformance: $(VENV)/.test
	$(BIN)/python -m tests.conformance

docs: $(VENV)/.test
	$(BIN)/python -m pip install -q --disable-pip-version-check -c requirements.lock -e ".[docs]"
	$(BIN)/python -m sphinx -q -W --keep-going docs build/docs
	@echo "Open build/docs/index.html"

web: $(VENV)/.test
	$(BIN)/python -m pip install -q --disable-pip-version-check -c requirements.lock -e ".[docs]"
	$(BIN)/python -m coursekit.building.web build/web

clean:
	rm -rf $(VENV) .venv-ros .venv-sdk build dist
