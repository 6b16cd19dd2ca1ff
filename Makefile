# The front door: `make help` lists all targets. CMake builds, gnuplot draws.

override SHELL := bash
.SHELLFLAGS    := -eo pipefail -c

# Options are those of the command line. What is exported decides neither what is made nor what is tested.
OPTIONS := FORMAT EQUATIONS FIG POINTS SEED HAND COUNT UNDER RUNS CASES ID TESTS PREFIX PYTHON CXX
$(if $(findstring e,$(filter-out --%,$(firstword -$(MAKEFLAGS)))),$(error make -e: exported variables must not replace those of the Makefile))
$(foreach name,$(OPTIONS),$(if $(filter environment,$(origin $(name))),$(warning \
  exported $(name)=$(value $(name)) is ignored; write make $(name)=... instead)$(eval unexport $(name))$(eval undefine $(name))))
unexport $(filter GTEST_% ROTOR_%,$(.VARIABLES))

FORMAT    ?= svg
EQUATIONS ?= both
FIG       ?=
POINTS    ?= 400
SEED      ?= 1
HAND      ?= 50
COUNT     ?= 100
UNDER     ?=
CASES     ?=
RUNS      ?= 1000
ID        ?=
TESTS     ?=
PREFIX    ?= /usr/local
PYTHON    ?= $(firstword $(wildcard /usr/bin/python3) python3)

# Options are text: neither make nor a shell runs what is in them. Other variables are no options.
$(foreach name,$(OPTIONS),$(if $(filter command,$(origin $(name))),$(eval override $(name) := $$(strip $$(value $(name))))))
$(foreach name,$(filter-out $(OPTIONS),$(shell sed -n 's/^ *\([A-Za-z_]*\) *[:?]*=.*/\1/p' Makefile)),$(if \
  $(filter command,$(origin $(name))),$(error $(name) is not an option; options are: $(OPTIONS))))
quote = '$(subst ','\'',$(1))'
SCENES    := $(sort $(wildcard figures/paper/fig[0-9][0-9].toml))
FIGURES   := $(SCENES:figures/paper/%.toml=%)

# Another compiler builds in its own folder: make verify CXX=clang++
BUILD := build
ifneq ($(filter-out default undefined,$(origin CXX)),)
  BUILD := build/$(notdir $(lastword $(filter-out -%,$(CXX))))
  $(if $(shell [[ $(call quote,$(BUILD)) =~ ^build/[A-Za-z][A-Za-z0-9_.+-]*$$ ]] && echo yes),,$(error CXX=$(CXX): must end in the name of a compiler, such as clang++))
  export CXX
endif
ROTOR := $(BUILD)/rotor

# CMake or Ninja has no escape for these.
hash := \#
$(foreach char,; " \ [ ] * ? < > | & ' ` ^ $$ $(hash),$(if $(findstring $(char),$(CURDIR)),$(error The path of this checkout, $(CURDIR), has a $(char), which CMake or Ninja cannot handle; move the checkout)))

# Misspelt options are reported before anything is built.
one_of = $(if $(and $(filter 1,$(words $($(1)))),$(filter $(2),$($(1)))),,$(error $(1)=$($(1)): must be one of: $(2)))
$(call one_of,FORMAT,svg pdf png)
$(call one_of,EQUATIONS,both published corrected consistent)
override EQUATIONS := $(EQUATIONS:consistent=corrected)
NUMBERS := $(FIGURES:fig%=%)
$(if $(filter-out $(NUMBERS) $(patsubst 0%,%,$(NUMBERS)),$(FIG)),$(error FIG=$(FIG): must be among: $(NUMBERS)))
whole = $(if $(shell n=$(call quote,$($(1))); [[ $$n =~ ^(0|[1-9][0-9]{0,8})$$ && $$n -ge $(2) ]] && echo yes),,$(error \
  $(1)=$($(1)): must be a whole number of at least $(2)))
$(call whole,POINTS,20)$(call whole,SEED,0)$(call whole,HAND,0)$(call whole,COUNT,0)$(call whole,RUNS,1)

# Data of each set of equations are in a folder of its own, and there a picture of it alone; one of both is above.
OUT    := $(BUILD)/figures
SETS   := $(if $(filter both,$(EQUATIONS)),published corrected,$(EQUATIONS))
DRAWN  := $(OUT)$(if $(filter-out both,$(EQUATIONS)),/$(EQUATIONS))
ASKED  := $(if $(FIG),$(shell printf '%s\n' $(FIG) | awk '{ printf "fig%02d ", $$1 }'),$(FIGURES))

# What `make deps` installs, and why.
#   g++ cmake ninja-build     compiler and build
#   libboost-dev              Odeint steppers, Math (automatic differentiation in tests)
#   libeigen3-dev             plane vectors
#   libcli11-dev libtomlplusplus-dev nlohmann-json3-dev libfmt-dev
#                             command line, scene files, JSON summary, messages and CSV
#   libgtest-dev              tests
#   libkainjow-mustache-dev   templates of the reviewer's page
#   gnuplot-nox fonts-dejavu-core
#                             pictures, and the font in them
PACKAGES := g++ cmake ninja-build libboost-dev libeigen3-dev libcli11-dev libtomlplusplus-dev \
            nlohmann-json3-dev libfmt-dev libgtest-dev libkainjow-mustache-dev \
            gnuplot-nox fonts-dejavu-core
# The library that the benchmark compares with.
BENCH_PACKAGES := libgsl-dev
LINT_PACKAGES  := clang-format clang-tidy python3
# The program that makes wrong changes needs only Python's standard library.
MUTANTS_PACKAGES := python3
# Another compiler; another processor, with a program that runs its programs here.
CLANG_PACKAGES    := clang libclang-rt-dev
PORTABLE_PACKAGES := g++-aarch64-linux-gnu qemu-user
# A browser that checks the reviewer's page, Node.js to drive it, and a dictionary for its words. Node.js
# from elsewhere includes npm and conflicts with Debian's.
REPORT_PACKAGES = chromium hunspell hunspell-en-gb $(if $(shell command -v npm),,nodejs npm)
# The engine in the page: a compiler for browsers, and the parser of its optimiser.
EXPLORE_PACKAGES := emscripten node-acorn
# Ball arithmetic with FLINT and Arb.
PROVE_PACKAGES := libflint-dev libflint-arb-dev
# A discrete-element code for granular media.
VALIDATE_PACKAGES := liggghts

installed = $(shell dpkg-query -W -f='$${db:Status-Abbrev}$${Package}\n' $(1) 2>/dev/null | sed -n 's/^ii *//p')
missing   = $(filter-out $(call installed,$(1)),$(1))
define install
	@if ! command -v apt-get >/dev/null; then \
	  echo "This installs with apt-get, which this system does not have. Needed are the equivalents of:"; \
	  echo "  $(1)"; exit 1; fi >&2
	@missing="$(call missing,$(1))"; [ -z "$$missing" ] || { \
	  sudo=$$([ $$(id -u) -eq 0 ] || echo sudo); $$sudo apt-get update -q; \
	  $$sudo env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends $$missing; }
endef

.DELETE_ON_ERROR:
.DEFAULT_GOAL := help
.PHONY: help deps need-deps program build install figures pictures $(FIGURES) approve reference ensembles reasons verify report \
        check-report deps-report claim lint mutants deps-bench bench-programs maps map-theory bench deps-lint \
        laws contact-laws deps-mutants deps-clang deps-portable deps-explore engine explore check-explore stress \
        sanitize portable deps-prove prove deps-validate validate clean force

help: ## start: list all targets
	@sed -n 's/^\([a-z0-9-]*\):.*## \([a-z]*\): \(.*\)/\2\t\1\t\3/p' Makefile | awk -F '\t' '\
	  { lines[$$1] = lines[$$1] sprintf("  %-15s %s\n", $$2, $$3) } \
	  END { print "make TARGET\n\nFirst:\n" lines["start"] "\nThe paper, its figures and claims:\n" lines["paper"] \
	    "  figNN           redraw one figure: NN from $(firstword $(NUMBERS)) to $(lastword $(NUMBERS))\n" \
	    "\nCompute again what is in reference-data:\n" lines["data"] "\nWork on the code:\n" lines["code"] }'
	@echo "What these need beyond make deps: make deps-NAME, NAME being one of"
	@echo "  $(sort $(patsubst deps-%:,%,$(shell grep -o '^deps-[a-z]*:' Makefile)))"
	@echo
	@echo "Options:"
	@echo "  FORMAT=svg|pdf|png, EQUATIONS=published|corrected, FIG=\"3 4\"     for figures"
	@echo "  POINTS=40 along each axis (default 400)                         for maps"
	@echo "  CASES=\"mu 0.3\": accidents with this in their names             for validate"
	@echo "  RUNS=100, drawn with SEED=7, to 3, 6, 9 and 12 digits           for stress"
	@echo "  PREFIX=/usr/local, the default                                  for install"
	@echo "  TESTS=\"Contact*\": tests with such names                         for sanitize"
	@echo "  SEED=7 HAND=50 COUNT=100 UNDER=\"model figures\": which changes  for mutants"

deps: ## start: install the Debian packages that are missing
	$(call install,$(PACKAGES))
deps-bench: deps
	$(call install,$(BENCH_PACKAGES))
deps-lint: deps
	$(call install,$(LINT_PACKAGES))
deps-mutants: deps
	$(call install,$(MUTANTS_PACKAGES))
deps-clang: deps
	$(call install,$(CLANG_PACKAGES))
deps-portable: deps
	$(call install,$(PORTABLE_PACKAGES))

deps-report: deps
	$(call install,$(REPORT_PACKAGES))
	@mkdir -p $(BUILD)/check-report && cp verification/report/package*.json $(BUILD)/check-report
	@cd $(BUILD)/check-report && npm ci --ignore-scripts --no-audit --no-fund

deps-prove: deps
	$(call install,$(PROVE_PACKAGES))

deps-validate: deps
	$(call install,$(VALIDATE_PACKAGES))

deps-explore: deps
	$(call install,$(EXPLORE_PACKAGES))

# On a system without dpkg, CMake and gnuplot report what is missing.
need-deps: $(if $(filter deps,$(MAKECMDGOALS)),deps)
	$(if $(shell mkdir -p $(BUILD) 2>/dev/null && test -w $(BUILD) && echo yes),,$(error $(BUILD): cannot be written))
	@! command -v dpkg-query >/dev/null || \
	for package in $(call missing,$(PACKAGES)); do \
	  echo "Missing package: $$package (make deps installs it)"; missing=1; done >&2; \
	[ -z "$$missing" ]

# Silent unless there is something to do or to report. CMake runs again if packages have changed, and
# `make -j1` runs one compiler. An optional program, $(2), needs $(3); what CMake knew of those is forgotten. Whether
# rotor has digits stays as it is, unless $(4) is stated.
home       = CMAKE_HOME_DIRECTORY:INTERNAL=
elsewhere  = $(shell grep -s ^$(home) $(BUILD)/CMakeCache.txt | grep -vxF $(call quote,$(home)$(CURDIR)))
configured = $(shell [ $(BUILD)/build.ninja -nt /var/lib/dpkg/status ] && [ $(BUILD)/build.ninja -nt CMakePresets.json ] && \
  grep -qx ROTOR_WITH:STRING= $(BUILD)/CMakeCache.txt && grep -qx 'ROTOR_DIGITS:BOOL=$(or $(4),.*)' $(BUILD)/CMakeCache.txt && echo yes)
define build-target
	$(if $(elsewhere),$(error $(BUILD) was made for another path, $(patsubst $(home)%,%,$(elsewhere)); remove it: make clean))
	$(if $(and $(2),$(shell command -v dpkg-query),$(call missing,$(3))),$(error Missing packages: $(call missing,$(3)) (make deps-$(2) installs them)))
	$(if $(and $(if $(2),,all),$(configured)),,@log=$$(flock $(BUILD) cmake --preset release -B $(BUILD) -D ROTOR_WITH=$(2)$(4:%= -D ROTOR_DIGITS=%) -U 'GSL_*' 2>&1) || { \
	  echo "$$log" >&2; $(if $(2),echo "Install $(3) anew for make $(2)." >&2; )exit 1; })
	@flock $(BUILD) cmake --build $(BUILD) --target $(1) $(filter -j%,$(MFLAGS))| sed -u '/no work to do\|Re-checking/d'
endef

program: need-deps
	$(call build-target,rotor,,,$(if $(wildcard $(BUILD)/CMakeCache.txt),,OFF))
build: program ## start: build build/rotor, with --digits, which make figures leaves out
	$(call build-target,rotor,,,ON)
$(ROTOR): program
install: build ## start: install the program and what it needs: make install PREFIX=/opt/rotor
	@cmake --install $(BUILD) --prefix $(call quote,$(PREFIX)) | sed -n 's/^-- [A-Z][a-z-]*: \(.*bin\/rotor\)$$/\1/p'

figures: pictures ## start: redraw Figs. 2-17 into build/figures
pictures: $(ASKED:%=$(DRAWN)/%.$(FORMAT))
$(FIGURES): %: $(DRAWN)/%.$(FORMAT)

# One process computes all data of a set, in a fraction of a second, and so damaged data are replaced each time.
# Unchanged data keep their time stamp, and their pictures are not drawn again.
define compute_data
	@mkdir -p $(@D) && new=$$(mktemp -d $(@D)/new.XXXXXX) && trap 'rm -rf "$$new"' EXIT && \
	$(ROTOR) figure --out "$$new" --equations $(notdir $(@D)) 2>&1 | sed '/^data of .* written$$/d' >&2 && \
	for file in "$$new"/*; do cmp -s "$$file" $(@D)/$${file##*/} || mv "$$file" $(@D)/; done
endef
$(foreach set,$(SETS),$(eval $(foreach end,csv var,$(FIGURES:%=$(OUT)/$(set)/%.$(end))) &: $(ROTOR) $(SCENES) force; $$(compute_data)))

STYLE := $(filter-out figures/paper/fig%,$(wildcard figures/paper/*.gp))    # what figures share
$(DRAWN)/%.$(FORMAT): $(foreach set,$(SETS),$(OUT)/$(set)/%.csv $(OUT)/$(set)/%.var) figures/paper/%.gp $(STYLE)
	@figures/draw.sh $@ "$(foreach set,$(SETS),data_$(set) = '$(OUT)/$(set)/$*.csv';)" figures/paper/$*.gp
$(DRAWN)/fig13.$(FORMAT) $(DRAWN)/fig14.$(FORMAT): reference-data/printed-inputs.csv reference-data/ensembles.csv
figures/paper/%.gp:
	$(if $(wildcard $@),,$(error The scene figures/paper/$*.toml has no script $@ that draws it))

# Maps of outcomes over two quantities, coarser ones in a subfolder. An interrupted sweep resumes.
MAPS         := $(filter-out rounding,$(patsubst figures/maps/%.toml,%,$(wildcard figures/maps/*.toml)))
MAP_OUT      := $(BUILD)/maps$(if $(filter-out 400,$(POINTS)),/$(POINTS))
MAP_PICTURES := $(foreach map,$(MAPS),$(MAP_OUT)/$(map)-outcome.$(FORMAT) $(MAP_OUT)/$(map)-force.$(FORMAT))
maps: $(MAP_PICTURES) $(MAP_OUT)/rounding.$(FORMAT) ## paper: draw the four reasons for the accident as maps (minutes)
.SECONDARY: $(foreach map,$(MAPS) rounding,$(foreach end,.toml .csv -theory.csv -tolerance.txt,$(MAP_OUT)/$(map)$(end)))
map-theory: build
	$(call build-target,map-theory)
$(BUILD)/map-theory: map-theory

# A map with an ensemble at each point has a tenth of the points, but at least ten.
$(MAP_OUT)/%.toml: figures/maps/%.toml
	@mkdir -p $(@D); sed -e 's/^points = 400$$/points = $(POINTS)/;t' -e "s/^points = 40$$/points = $$(($(POINTS) < 100 ? 10 : $(POINTS) / 10))/" $< > $@
$(MAP_OUT)/%.csv: $(MAP_OUT)/%.toml $(ROTOR)
	@$(ROTOR) sweep $< --force --out $@
# The lines of a coarse map are as fine as those of a full one.
$(MAP_OUT)/%-theory.csv: figures/maps/%.toml $(BUILD)/map-theory
	@mkdir -p $(@D); $(BUILD)/map-theory $< > $@
$(MAP_OUT)/%-tolerance.txt: figures/maps/%.toml figures/maps/tolerance.sh $(ROTOR)
	@mkdir -p $(@D); figures/maps/tolerance.sh $(ROTOR) $< $(@D) > $@
$(MAP_OUT)/rounding-shares.csv: $(MAP_OUT)/rounding.csv figures/maps/shares.awk
	@awk -f figures/maps/shares.awk $< > $@
MAP_STYLE := figures/maps/map.gp $(STYLE)
$(MAP_OUT)/%-outcome.$(FORMAT): $(MAP_OUT)/%.csv $(MAP_OUT)/%-theory.csv $(MAP_OUT)/%-tolerance.txt figures/maps/%.gp $(MAP_STYLE)
	@figures/draw.sh $@ "data = '$<'; theory = '$(word 2,$^)'; note = '$(word 3,$^)'; shows = 'outcome'" figures/maps/$*.gp figures/maps/map.gp
$(MAP_OUT)/%-force.$(FORMAT): $(MAP_OUT)/%.csv $(MAP_OUT)/%-theory.csv $(MAP_OUT)/%-tolerance.txt figures/maps/%.gp $(MAP_STYLE)
	@figures/draw.sh $@ "data = '$<'; theory = '$(word 2,$^)'; note = '$(word 3,$^)'; shows = 'force'" figures/maps/$*.gp figures/maps/map.gp
$(MAP_OUT)/rounding.$(FORMAT): $(MAP_OUT)/rounding-shares.csv $(MAP_OUT)/rounding-tolerance.txt figures/maps/rounding.gp $(STYLE)
	@figures/draw.sh $@ "data = '$<'; note = '$(word 2,$^)'" figures/maps/rounding.gp

verify: build ## start: run all tests, and give the verdict on each claim
	$(call build-target,all)
	@verification/verify.sh $(BUILD)

verify-%: build # the tests of one folder, such as verify-equations
	$(call build-target,verify-$* map-theory accident)
	@verification/tests.sh $(BUILD) verify-$*

claim: build ## paper: print all that is known about one claim: make claim ID=speed; or list them
	$(call build-target,report-numbers)
	@$(BUILD)/report-numbers reference-data claim $(call quote,$(ID))

# With the engine where that is asked for, so that it is never an older one.
ENGINE := $(if $(filter explore check-explore,$(MAKECMDGOALS)),engine)
report: build | $(ENGINE) ## start: make the page, build/report/index.html: one file, no network
	$(call build-target,report-page report-numbers map-theory)
	@$(MAKE) --no-print-directory -s pictures FORMAT=svg FIG= EQUATIONS=both
	@verification/report/report.sh $(BUILD) $(ENGINE)
check-report: report ## code: check the page in a browser, its links and its spelling
	@verification/report/check.sh $(BUILD)

approve: build ## code: rewrite approved texts and tables; read the change
	$(call build-target,verification)
	@ROTOR_APPROVE=1 $(BUILD)/verification --gtest_brief=1 --gtest_filter='*Approved*' && git diff --stat

lint: need-deps ## code: check the format, and look for mistakes with clang-tidy
	@verification/lint.sh $(BUILD)

sanitize: need-deps ## code: run the tests with sanitizers
	@cmake --preset sanitize -B $(BUILD)/sanitize >$(BUILD)/sanitize.log 2>&1 || { cat $(BUILD)/sanitize.log >&2; exit 1; }
	@cmake --build $(BUILD)/sanitize --target verification
	@verification/tests.sh $(BUILD)/sanitize verification$(if $(TESTS), $(call quote,$(TESTS)))

engine: need-deps
	@verification/report/engine/build.sh $(BUILD)
explore: engine report ## paper: make the page with the engine: drag to rerun the accident

check-explore: explore check-report ## code: check the page with the engine, compared with the program

portable: build ## code: build for another processor, and compare to the last bit
	@verification/program/portable.sh $(BUILD)

mutants: need-deps ## code: break the program in ways that tests must notice (minutes)
	@$(call quote,$(PYTHON)) -B verification/robustness/mutants.py --seed $(SEED) --hand $(HAND) --count $(COUNT) --under $(call quote,$(UNDER))

reference: build ## data: high-precision.csv (minutes)
	$(call build-target,reference)
	@$(BUILD)/reference reference-data/high-precision.csv

ensembles: build ## data: ensembles.csv: claims over the rounding of inputs (minutes), or one ID
	$(call build-target,ensembles)
	@$(BUILD)/ensembles reference-data 1000 $(if $(ID),$(call quote,$(ID)),$(if $(filter-out 1,$(SEED)),seed $(SEED) $(BUILD)/ensembles-$(SEED).csv))

prove: need-deps ## data: proven.csv: the accident by ball arithmetic (minutes)
	$(call build-target,prove prover-tests,prove,$(PROVE_PACKAGES))
	@$(BUILD)/prover-tests --gtest_brief=1
	@verification/proof/theorems.sh $(BUILD)/prove reference-data/proven.csv

# With CASES nothing outside build is written.
validate: build ## data: independent.csv: accidents by an independent code (minutes)
	$(if $(and $(shell command -v dpkg-query),$(call missing,$(VALIDATE_PACKAGES))),$(error Missing packages: $(call missing,$(VALIDATE_PACKAGES)) (make deps-validate installs them)))
	$(call build-target,validate)
	@mkdir -p $(BUILD)/validation
	@$(BUILD)/validate $(BUILD)/validation $(if $(CASES),$(BUILD)/validation/cases.csv $(call quote,$(CASES)),reference-data/independent.csv)
	@$(ROTOR) run --equations corrected --from 29.1 --until 29.1344 --columns time_s,normal_force_N \
	  --trace $(BUILD)/validation/engine.csv >/dev/null
	@figures/draw.sh $(if $(CASES),$(BUILD)/validation,verification/validation)/validation.svg \
	  "folder = '$(BUILD)/validation'" verification/validation/validation.gp

reasons: build ## data: reasons-tried.csv: reasons for the accident on 5000 rotors
	$(call build-target,reasons)
	@$(BUILD)/reasons reference-data 1000

contact-laws: build ## data: contact-laws.csv: other laws of the ring, with a picture (minutes)
	$(call build-target,contact-laws)
	@$(BUILD)/contact-laws reference-data 100
	@verification/paper/contact_laws.sh $(ROTOR) $(BUILD)/contact-laws-traces

laws: build ## data: laws.csv: the closed forms on 10,000 rotors, with a picture
	@mkdir -p $(BUILD)/laws && $(ROTOR) sweep verification/paper/laws.toml --force --out $(BUILD)/laws/laws.csv
	@$(ROTOR) sweep verification/paper/region.toml --force --out $(BUILD)/laws/region.csv
	@verification/paper/laws.sh $(BUILD)/laws/laws.csv $(BUILD)/laws/region.csv > $(BUILD)/laws/quantiles.csv
	@mv $(BUILD)/laws/quantiles.csv reference-data/laws.csv
	@figures/draw.sh model/theory/parity.svg "data = '$(BUILD)/laws/laws.csv'" verification/paper/laws.gp

bench-programs: build ## code: build the programs of make bench, stress and reference
	$(call build-target,benchmark random-rotors reference random-digits,bench,$(BENCH_PACKAGES))
bench: bench-programs ## code: measure run time against error of each method, and draw it
	@mkdir -p $(BUILD)/bench && $(BUILD)/benchmark $(BUILD)/bench
	@figures/draw.sh verification/benchmark/work-precision.svg "data = '$(BUILD)/bench/work-precision.csv'" \
	  verification/benchmark/work-precision.gp

stress: build ## code: test 5,000 random rotors and estimated digits (minutes)
	$(call build-target,random-rotors random-digits)
	@mkdir -p $(BUILD)/stress-results && $(BUILD)/random-rotors 5000 $(BUILD)/stress-results
	@$(BUILD)/random-digits $(RUNS) $(SEED)

clean: ## start: remove the folder build
	rm -rf $(BUILD)
