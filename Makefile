# make lab: open the course.  make test: prove that it works.  Both set up all they need in .venv.
PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
JOBS ?= 2

.PHONY: lab test check bench class conformance notebooks wheel windows clean

$(VENV)/.lab: pyproject.toml requirements.lock
	$(PYTHON) -m venv $(VENV)
	$(BIN)/python -m pip install -q --disable-pip-version-check -c requirements.lock -e .
	@touch $@

$(VENV)/.test: $(VENV)/.lab
	$(BIN)/python -m pip install -q --disable-pip-version-check -c requirements.lock -e '.[test]'
	@touch $@

lab: $(VENV)/.lab
	$(BIN)/coursekit lab

test: $(VENV)/.test
	$(BIN)/python -m pytest -n $(JOBS) --dist loadfile
	COURSEKIT_TIME=virtual $(BIN)/python -m pytest -n $(JOBS) --dist loadfile -p tests.notebooks.own_course --nbval --nbval-cell-timeout 120 notebooks

notebooks: $(VENV)/.test
	$(BIN)/python -m tests.notebooks.store

check: $(VENV)/.test
	$(BIN)/ruff check .
	$(BIN)/mypy
	$(BIN)/python -m pytest -n $(JOBS) --dist loadfile -m "not slow" tests/core tests/interfaces tests/launch tests/cli

bench: $(VENV)/.test
	$(BIN)/python -m tests.benchmarks

class: $(VENV)/.test
	$(BIN)/python -m tests.grade

windows: $(VENV)/.test
	$(BIN)/python -m tests.windows

wheel: $(VENV)/.lab
	$(BIN)/python -m pip wheel -q --disable-pip-version-check --no-deps -w dist .
	@ls dist/*.whl

conformance: $(VENV)/.test
	$(BIN)/python -m tests.conformance

clean:
	rm -rf $(VENV) .venv-ros build dist
