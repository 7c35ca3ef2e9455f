# Everything wraparc needs beyond Python 3.11+ and make is fetched by the targets here,
# pinned (uv by version, the rest by uv.lock), into .venv and build/ of this folder.

find_python = for p in python3.11 python3 python; do "$$p" -c 'import sys; print(sys.executable)' 2>/dev/null && break; done
PYTHON ?= $(shell $(find_python))
UV_VERSION := 0.13.8
UV := build/uv/$(UV_VERSION)/bin/uv
BIN := .venv/bin
NODE := node_modules/.bin
# More than processors do not end sooner: each starts a browser and a server of its own.
WORKERS ?= 2
# After so long `make check` begins no further test, and says how many are left to `make test`.
SECONDS_OF_CHECK ?= 75

export UV_PROJECT_ENVIRONMENT := .venv
export UV_PYTHON_DOWNLOADS := never
export UV_PYTHON := $(PYTHON)
export MPLBACKEND := Agg
export MPLCONFIGDIR := $(CURDIR)/build/matplotlib
export IPYTHONDIR := $(CURDIR)/build/ipython
export JUPYTER_CONFIG_DIR := $(CURDIR)/build/jupyter
export JUPYTER_RUNTIME_DIR := $(CURDIR)/build/jupyter/runtime
# Bytecode is kept, also where the shell asks otherwise: a start without it takes three times as long.
unexport VIRTUAL_ENV PYTHONPATH PYTHONHOME PYTHONDONTWRITEBYTECODE

# From the cache where it suffices (fast, and works without a network), else from the index.
sync = $(UV) sync --quiet --offline $(1) 2>/dev/null || $(UV) sync --quiet $(1)

CHECKED := src tests $(wildcard benchmarks) docs/conf.py docs/building tools

.DEFAULT_GOAL := help
.PHONY: help demo serve test check near dev format hooks lint types docs site installed system tests kernel page audit bench lock clean

help: ## show this list
	@sed -n 's/^\([a-z]*\):.*## /\1|/p' Makefile | while IFS='|' read -r t d; do printf '  make %-8s %s\n' "$$t" "$$d"; done

demo: $(UV) ## solve an example drive and draw it (sets itself up)
	@echo "== installing wraparc into .venv (locked versions)"
	@$(call sync,--frozen --inexact --no-default-groups --extra plot --extra web)
	@$(BIN)/wraparc demo

serve: $(UV) ## open the calculator in the browser (sets itself up); FILE=drive.toml for a drive
	@echo "== installing wraparc with its calculator into .venv (locked versions)"
	@$(call sync,--frozen --inexact --no-default-groups --extra web --extra fit --extra study)
	@$(BIN)/wraparc serve --open $(FILE)

test: ## the whole gate (sets itself up); a log a part in build/gate
	@$(PYTHON) tools/gate.py

check: ## before a commit: format, lint, types, tests of what changed and of what stands on it
	@$(PYTHON) tools/gate.py --changed

dev: $(UV) node_modules/.locked ## install everything a developer needs into .venv and node_modules
	@echo "== environment: every extra and the developer tools, as locked"
	@$(call sync,--locked --all-extras --all-groups)

# The tools that check the page's JavaScript; the page itself needs none of them.
node_modules/.locked: package.json package-lock.json
	@command -v npm >/dev/null || $(MAKE) --no-print-directory system
	@echo "== tools of the page: as locked, into node_modules"
	@npm ci --silent --no-audit --no-fund --prefer-offline && touch $@

format: dev
	@echo "== format: ruff format --check, biome format"
	@$(BIN)/ruff format --check $(CHECKED)
	@$(NODE)/biome format
	@left=$$(git ls-files --others --exclude-standard src 2>/dev/null); test -z "$$left" || \
	  { printf 'no commit would have these; git add or remove them:\n%s\n' "$$left"; exit 1; }

hooks: ## look at the title of every commit before it is made, from now on
	@git config core.hooksPath tools/hooks
	@echo "titles of commits are read by tools/titles.py; no longer: git config --unset core.hooksPath"

lint: dev
	@echo "== lint: ruff check, biome lint, titles of commits"
	@$(BIN)/ruff check $(CHECKED)
	@$(NODE)/biome lint --error-on-warnings
	@$(BIN)/python tools/titles.py

types: dev
	@echo "== types: mypy --strict, tsc --checkJs"
	@$(BIN)/mypy --strict $(CHECKED)
	@$(NODE)/tsc --project tsconfig.json

docs: dev ## build the documentation into build/docs, running its code; check its links
	@echo "== docs: sphinx, warnings are errors, every code cell runs"
	@$(BIN)/python -W ignore -m sphinx -W --keep-going -n -q -E -b html -d build/doctrees docs build/docs
	@$(BIN)/python docs/building/links.py build/docs README.md CONTRIBUTING.md CHANGELOG.md
	@echo "documentation: build/docs/index.html"

# The lowest versions that pyproject.toml allows (make lock), and every newer Python that is here.
installed: dev ## build wheel and sdist; install them, also with the lowest libraries; try each
	@echo "== installed: wheel and sdist, lowest versions of the libraries, other Pythons"
	@UV="$(CURDIR)/$(UV)" $(BIN)/python tests/installed/check.py

# Programs that no Python package brings: for the checks of the page, the tests of the calculator
# and its database, and those in other languages.
headless = $(shell command -v chromium-headless-shell || command -v chrome-headless-shell)
browser = $(or $(headless),$(shell command -v chromium || command -v chromium-browser || command -v google-chrome))
initdb = $(firstword $(wildcard /usr/lib/postgresql/*/bin/initdb) $(shell command -v initdb))
npm = $(shell command -v npm)
firefox = $(shell command -v firefox-esr || command -v firefox)
turkish = $(or $(wildcard /usr/share/i18n/locales/tr_TR),$(shell locale -a 2>/dev/null | grep tr_TR))
lacking = $(if $(browser),,chromium) $(if $(firefox),,firefox-esr) $(if $(initdb),,postgresql) $(if $(npm),,nodejs npm) \
  $(if $(turkish),,locales)

install = test "$$(id -u)" = 0 && command -v apt-get >/dev/null && \
  { apt-get install -qq -y --no-install-recommends $(1) >/dev/null || \
    { apt-get update -qq && apt-get install -qq -y --no-install-recommends $(1) >/dev/null; }; }

# Chromium without its windows does the same tests at half the cost; where it cannot be had, the
# whole of it does.
site: dev ## documentation, examples and calculator as a static site in build/site
	@echo "== site: documentation, examples, calculator"
	@$(BIN)/python -W ignore -m sphinx -W --keep-going -n -q -E -b html -t site -d build/doctrees-site docs build/site
	@$(BIN)/python tools/site_pages.py build/site
	@echo "site: build/site/index.html"

system: ## install Chromium, Firefox, PostgreSQL, Node.js and locales for the gate where they are missing
	@test -n "$(headless)" || { $(call install,chromium-headless-shell); } 2>/dev/null || true
	@test -z "$(strip $(lacking))" || { \
	  echo "== system: installing $(strip $(lacking))"; $(call install,$(lacking)); } || \
	  { echo "the gate needs $(strip $(lacking)), which could not be installed here; as root on Debian or Ubuntu: apt-get install $(strip $(lacking))" >&2; exit 1; }

pytest = $(BIN)/python -m pytest --no-header -n $(WORKERS) --dist loadfile --no-loadscope-reorder -W error

# One test alone: make tests WORKERS=0 TESTS='tests/test_units.py::test_name'
tests: dev system
	@echo "== tests: pytest, warnings are errors"
	@$(pytest) $${TESTS:+"$$TESTS"}

near: dev system
	@echo "== tests of what changed and of what stands on it, for $(SECONDS_OF_CHECK) s"
	@mkdir -p build/gate && $(BIN)/python tools/changed.py > build/gate/near.txt
	@tr '\n' '\0' < build/gate/near.txt | xargs -0 $(pytest) --budget $(SECONDS_OF_CHECK)

kernel: dev ## make the solver of the page and the page of one file anew, after a change of either
	@$(BIN)/python tools/page_kernel.py

page: dev ## serve the calculator and make it anew whenever its source changes; FILE=drive.toml
	@$(BIN)/python tools/page_watch.py $(FILE)

audit: $(UV) ## ask what holes are known of the locked libraries (needs a network)
	@$(PYTHON) tools/audit.py "$(CURDIR)/$(UV)"

bench: dev ## measure speed (ratios within one run)
	@echo "== benchmarks"
	@$(BIN)/python -m pytest -q -o addopts="" -o timeout=0 -W error benchmarks

lock: $(UV) ## resolve the dependencies anew and write uv.lock, lowest.txt and package-lock.json
	@$(UV) lock
	@$(UV) pip compile --quiet --universal --resolution lowest-direct --all-extras --no-annotate \
	  --no-header --output-file tests/installed/lowest.txt pyproject.toml
	@npm install --silent --no-audit --no-fund --package-lock-only

clean: ## remove everything that make installed or built
	rm -rf .venv build node_modules

$(UV):
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || \
	  { echo "wraparc needs Python 3.11 or newer; name it: make PYTHON=/path/to/python3.11" >&2; exit 1; }
	@$(PYTHON) -c 'import ensurepip, venv' 2>/dev/null || \
	  { echo "$(PYTHON) cannot make virtual environments; on Debian or Ubuntu: apt-get install python3-venv" >&2; exit 1; }
	@echo "== fetching uv $(UV_VERSION) into build/uv"
	@rm -rf build/uv && $(PYTHON) -m venv build/uv/$(UV_VERSION)
	@build/uv/$(UV_VERSION)/bin/python -m pip install --quiet --disable-pip-version-check "uv==$(UV_VERSION)" || \
	  { rm -rf build/uv; exit 1; }
