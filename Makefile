# The front door: `make help` lists what there is. CMake does the building, gnuplot the drawing.

SHELL       := bash
.SHELLFLAGS := -o pipefail -c

FORMAT    ?= svg
EQUATIONS ?= published
BUILD     := build
NUMBERS   := $(patsubst figures/fig%.toml,%,$(sort $(wildcard figures/fig*.toml)))

# Figures of the published equations stand in build/figures, others in a folder of their own.
OUT   := $(BUILD)/figures$(if $(filter-out published,$(EQUATIONS)),/$(EQUATIONS))
DRAW  ?= $(NUMBERS)
ROTOR := $(BUILD)/rotor

# What `make deps` installs, and why.
#   g++ cmake ninja-build     compiler and build
#   libboost-dev              Odeint steppers, Geometry, Math (automatic differentiation in tests)
#   libeigen3-dev             plane vectors
#   libcli11-dev libtomlplusplus-dev nlohmann-json3-dev libfmt-dev
#                             command line, scene files, JSON summary, messages and CSV
#   libgtest-dev librapidcheck-dev
#                             tests, and properties on random rotors
#   gnuplot-nox fonts-dejavu-core
#                             pictures, and the font in them
PACKAGES := g++ cmake ninja-build libboost-dev libeigen3-dev libcli11-dev libtomlplusplus-dev \
            nlohmann-json3-dev libfmt-dev libgtest-dev librapidcheck-dev gnuplot-nox fonts-dejavu-core
missing = $(shell dpkg-query -W -f='$${db:Status-Abbrev} $${Package}\n' $(PACKAGES) 2>/dev/null | \
            awk '/^ii/ { have[$$2] = 1 } END { split("$(PACKAGES)", all); \
                 for (i = 1; i in all; ++i) if (!(all[i] in have)) printf "%s ", all[i] }')

# Quiet unless there is something to do or to complain of.
define configure-and-build
{ log=$$(cmake --preset release 2>&1) || { echo "$$log" >&2; exit 1; }; } && \
cmake --build $(BUILD) $(1) | sed -u '/no work to do/d'
endef

.DELETE_ON_ERROR:
.DEFAULT_GOAL := help
.PHONY: help deps need-deps build figures draw data reference verify mutants deps-bench bench stress clean

help: ## list all targets
	@sed -n 's/^[$$(].*## \(.*\): /\1:## /; s/^\([a-z0-9. ]*\):.*## \(.*\)/\1\t\2/p' Makefile | \
	  awk -F '\t' '{ printf "  make %-18s %s\n", $$1, $$2 }'
	@echo "Options: FORMAT=svg|pdf|png, EQUATIONS=published|consistent"

deps: ## install the Debian packages that are missing
	@if ! command -v apt-get >/dev/null; then \
	  echo "make deps installs with apt-get, which this system does not have. Needed are the equivalents of:"; \
	  echo "  $(PACKAGES)"; exit 1; \
	elif [ -n "$(strip $(missing))" ]; then \
	  sudo=$$([ $$(id -u) -eq 0 ] || echo sudo); \
	  $$sudo apt-get update -q && \
	  $$sudo env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends $(missing); \
	fi

# On a system without dpkg, CMake and gnuplot speak for themselves.
need-deps:
	@if command -v dpkg-query >/dev/null && [ -n "$(strip $(missing))" ]; then \
	  echo "Missing packages: $(missing)"; echo "Install them with: make deps"; exit 1; \
	fi >&2

build: need-deps ## build the program, build/rotor
	@$(call configure-and-build,--target rotor)

figures: build ## redraw Figs. 2-17 into build/figures
	@$(MAKE) --no-print-directory draw

$(NUMBERS:%=fig%): fig%: build ## fig02 ... fig17: redraw one figure
	@$(MAKE) --no-print-directory draw DRAW=$*

# All data that are out of date come from one process; then each picture is drawn on its own.
draw:
	@start=$$(date +%s%N); \
	stale=$$(for n in $(DRAW); do \
	  csv=$(OUT)/fig$$n.csv; \
	  [ $$csv -nt figures/fig$$n.toml ] && [ $$csv -nt $(ROTOR) ] || echo $$n; \
	done); \
	[ -z "$$stale" ] || $(ROTOR) figure $$stale --out $(OUT) --equations $(EQUATIONS) || exit 1; \
	computed=$$(date +%s%N); \
	if $(MAKE) -q pictures DRAW="$(DRAW)"; then echo "The figures in $(OUT) are up to date."; else \
	  $(MAKE) --no-print-directory $(if $(findstring j,$(MAKEFLAGS)),,-j$$(nproc)) pictures DRAW="$(DRAW)" && \
	  echo "$$start $$computed $$(date +%s%N)" | \
	    awk '{ printf "data %.1f s, gnuplot %.1f s\n", ($$2 - $$1)/1e9, ($$3 - $$2)/1e9 }'; \
	fi

.PHONY: pictures
pictures: $(DRAW:%=$(OUT)/fig%.$(FORMAT))

$(OUT)/fig%.$(FORMAT): figures/fig%.gp figures/style.gp $(OUT)/fig%.csv
	@gnuplot -e "data = '$(OUT)/fig$*.csv'; output = '$@.part'; format = '$(FORMAT)'; \
	  equations = '$(EQUATIONS)'" figures/style.gp $< || { rm -f $@.part; exit 1; }
	@mv $@.part $@ && echo "$@"

$(OUT)/fig%.csv: ;

reference: need-deps ## recompute reference-data/high-precision.csv in quadruple precision (minutes)
	@$(call configure-and-build,--target reference)
	@$(BUILD)/reference reference-data/high-precision.csv

verify: need-deps ## build, run all tests, and hold the published numbers against ours
	@$(call configure-and-build)
	@mkdir -p $(BUILD)/report
	@failed=0; report=$(BUILD)/report; rm -f $$report/verification.json; \
	RC_PARAMS=seed=1 $(BUILD)/verification --gtest_brief=1 \
	  --gtest_output=json:$$report/verification.json || failed=1; \
	$(BUILD)/report-numbers $$report/verification.json reference-data/published-values.csv \
	  reference-data/assumptions.csv $$report/published-values.csv | tee $$report/report.txt || failed=1; \
	$(BUILD)/stress rotors 300 $$report | tee -a $$report/report.txt || failed=1; \
	echo; echo "This report: $$report/report.txt"; exit $$failed

mutants: need-deps ## break the model on purpose in many ways: the tests must notice each (an hour or two)
	@verification/mutants.sh

# The peers: libsundials-dev and libgsl-dev in C, SciPy in Debian's Python; libbenchmark-dev times
# single evaluations.
PEERS := libsundials-dev libgsl-dev python3-scipy libbenchmark-dev
deps-bench: deps ## install the peers that the benchmark compares with (optional)
	@sudo=$$([ $$(id -u) -eq 0 ] || echo sudo); \
	$$sudo env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends $(PEERS)

PYTHON ?= $(firstword $(wildcard /usr/bin/python3) python3)
bench: need-deps ## run time against error of every method, with pictures, into build/bench
	@$(call configure-and-build,--target benchmark scene-costs)
	@for peer in SUNDIALS GSL; do \
	  grep -q ROTOR_$$peer $(BUILD)/build.ninja || echo "Without $$peer, which make deps-bench installs."; done
	@$(BUILD)/benchmark $(BUILD)/bench $(PYTHON) verification/scipy_peer.py
	@echo && $(BUILD)/scene-costs figures
	@gnuplot -e "data = '$(BUILD)/bench/work-precision.csv'; output = '$(BUILD)/bench/.first'; \
	  folder = '$(BUILD)/bench'; format = '$(FORMAT)'" figures/style.gp verification/work-precision.gp
	@rm -f $(BUILD)/bench/.first && echo "$(BUILD)/bench/work-precision-*.$(FORMAT)"
	@if grep -q micro_costs $(BUILD)/build.ninja; then \
	  cmake --build $(BUILD) --target micro-costs >/dev/null && $(BUILD)/micro-costs; \
	else echo "Without Google Benchmark, which make deps-bench installs."; fi

stress: need-deps ## a hundred thousand random rotors, stability, precision: numbers and pictures (minutes)
	@$(call configure-and-build,--target stress precision)
	@$(BUILD)/stress rotors 100000 $(BUILD)/stress-results
	@$(BUILD)/stress steps $(BUILD)/stress-results
	@$(BUILD)/precision reference-data/high-precision.csv $(BUILD)/stress-results
	@gnuplot -e "folder = '$(BUILD)/stress-results'; format = '$(FORMAT)'; output = folder.'/.first'" \
	  figures/style.gp verification/stress.gp
	@rm -f $(BUILD)/stress-results/.first && ls $(BUILD)/stress-results/*.$(FORMAT)

clean: ## remove everything that was made
	rm -rf $(BUILD)
