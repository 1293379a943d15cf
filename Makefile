# The few verbs of daily work; bash .ci/run is what CI runs.
python := .venv/bin/python

.PHONY: install test lint format fuzz docs ci

install: .venv/bin/python
	$(python) -m pip install --quiet --editable '.[test]'

.venv/bin/python:
	python3 -m venv .venv

test: ## e.g. make test only=tests/spec
	$(python) -m pytest -q -n auto --dist loadfile $(only)

lint:
	$(python) -m ruff check .
	$(python) -m ruff format --check .
	$(python) -m mypy

format:
	$(python) -m ruff check --fix .
	$(python) -m ruff format .

fuzz:
	FUZZ_SECONDS=60 FUZZ_SEED=$$(date +%s) $(python) -m pytest -q -rP -n 2 -m fuzz tests/cli/test_fuzz.py

docs:
	$(python) -m pip install --quiet --editable '.[docs]'
	$(python) -m mkdocs build --strict

ci:
	bash .ci/run
