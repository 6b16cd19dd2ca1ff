# The front door. CMake and Ninja know what each figure, map, page and table depends on; gnuplot draws.
# `make help` prints the lines with two #.

# Options are those of the command line: `:=` ignores what is exported.
FORMAT    := svg
EQUATIONS := both
FIG       :=
POINTS    := 400
CASES     :=
ID        :=
RUNS      := 1000
SEED      := 1
HAND      := 50
COUNT     := 100
UNDER     :=
TESTS     :=
FILE      :=
PREFIX    := /usr/local
CXX       := c++

# Misspelt ones are refused before anything is built.
OPTIONS := FORMAT EQUATIONS FIG POINTS CASES ID RUNS SEED HAND COUNT UNDER TESTS FILE PREFIX CXX
FIGURES := $(patsubst figures/paper/%.toml,%,$(sort $(wildcard figures/paper/fig[0-9][0-9].toml)))
one_of   = $(if $(and $(filter 1,$(words $($(1)))),$(filter $(2),$($(1)))),,$(error $(1)=$($(1)): must be one of: $(2)))
whole    = $(if $(shell echo '$($(1))' | grep -x '0\|[1-9][0-9]\{0,8\}'),,$(error $(1)=$($(1)): must be a whole number))
figure   = $(or $(filter fig$(1) fig0$(1),$(FIGURES)),$(error FIG=$(FIG): must be among: $(FIGURES:fig%=%)))
$(if $(findstring e,$(filter-out --%,$(firstword -$(MAKEFLAGS)))),$(error make -e: what is exported must not replace options))
$(foreach name,$(filter-out $(OPTIONS),$(.VARIABLES)),$(if $(filter command,$(origin $(name))), \
  $(error $(name) is not an option; options are: $(OPTIONS))))
$(foreach name,$(OPTIONS),$(foreach char,$$ ',$(if $(findstring $(char),$(value $(name))), \
  $(error $(name)=$(value $(name)): must be without $(char)))))
$(call one_of,FORMAT,svg pdf png)
$(call one_of,EQUATIONS,both published corrected)
$(foreach name,POINTS RUNS SEED HAND COUNT,$(call whole,$(name)))
$(if $(shell echo '$(CXX)' | grep -x '[A-Za-z0-9_./+ -]*[a-z]++[0-9.-]*'),,$(error CXX=$(CXX): must end in the name of a compiler, such as clang++))

# Another compiler than the system's builds in a folder of its own: make verify CXX=clang++
BUILD := build$(if $(filter-out c++,$(CXX)),/$(notdir $(lastword $(CXX))))
build  = figures/make/build.sh $(BUILD) $(filter -j%,$(MFLAGS))
text   = '$(strip $($(1)))'

# Pictures of one set of equations are in a folder of its own. An option names figures, or all are drawn.
PLACE := figures$(if $(filter-out both,$(EQUATIONS)),/$(EQUATIONS))
ASKED := $(if $(FIG),$(foreach number,$(FIG),$(call figure,$(number))),$(FIGURES))

.NOTPARALLEL: # `make -j4 deps figures` in this order: -j is for Ninja
.PHONY: help deps build install figures $(FIGURES) maps claim verify report check-report explore check-explore engine approve \
        dist lint sanitize races portable mutants bench-programs bench score stress reference ensembles prove validate reasons \
        contact-laws laws clean

## make TARGET
##
## First:
help: ## list all targets
	@sed -n 's/^## \?//p; s/^\([a-z%-]*\):.* ## /  \1\t/p' Makefile | sed 's/%/NAME/' | expand -t 18

deps: ## install the Debian packages that are missing
	@figures/make/packages.sh install $@

build: ## build build/rotor, with --digits, which make figures leaves out
	@$(build) rotor

install: build ## install program, examples and library: make install PREFIX=/opt/rotor
	@cmake --install $(BUILD) --prefix $(call text,PREFIX) >/dev/null && echo $(call text,PREFIX)/bin/rotor

figures: ## redraw Figs. 2-17 into build/figures
	@$(build) --without-digits $(ASKED:%=$(PLACE)/%.$(FORMAT))

verify: ## run all tests, and give the verdict on each claim
	@$(build) all && verification/verify.sh $(BUILD)

report: ## make the page, build/report/index.html: one file, no network
	@$(build) page-parts && verification/report/report.sh $(BUILD)

clean: ## remove the folder build
	rm -rf $(BUILD)

##
## The paper, its figures and claims:
maps: ## draw the four reasons for the accident as maps
	@figures/make/maps.sh $(BUILD) $(POINTS) $(FORMAT) $(filter -j%,$(MFLAGS))

claim: ## print all that is known about one claim: make claim ID=speed; or list them
	@$(build) report-numbers && $(BUILD)/report-numbers reference-data claim $(call text,ID)

explore: engine ## make the page with the engine: drag to rerun the accident
	@$(build) page-parts && verification/report/report.sh $(BUILD) engine

##   fig03           redraw one figure
$(FIGURES):
	@$(build) --without-digits $(PLACE)/$@.$(FORMAT)

##
## Compute again what is in reference-data:
reference: ## high-precision.csv
	@$(build) reference && $(BUILD)/reference reference-data/high-precision.csv

ensembles: ## ensembles.csv: claims over the rounding of inputs, or one ID
	@$(build) ensembles && $(BUILD)/ensembles reference-data 1000 \
	  $(if $(ID),$(call text,ID),$(if $(filter-out 1,$(SEED)),seed $(SEED) $(BUILD)/ensembles-$(SEED).csv))

prove: ## proven.csv: the accident by ball arithmetic
	@$(build) --with prove prove prover-tests && verification/tests.sh $(BUILD) prover-tests && \
	  verification/proof/theorems.sh $(BUILD)/prove reference-data/proven.csv

validate: ## independent.csv: accidents and problems by an independent code
	@$(build) --with validate validate rotor && verification/validation/validate.sh $(BUILD) $(call text,CASES)

reasons: ## reasons-tried.csv: reasons for the accident on 5000 rotors
	@$(build) reasons && $(BUILD)/reasons reference-data 1000

contact-laws: ## contact-laws.csv: other laws of the ring, with a picture
	@$(build) contact-laws rotor && verification/paper/contact_laws.sh $(BUILD)

laws: ## laws.csv: the closed forms on 50,000 rotors, with a picture
	@$(build) law-accuracy rotor && verification/paper/laws.sh $(BUILD)

##
## Work on the code:
verify-%: ## run the tests of one folder, such as verify-equations
	@$(build) $@ && verification/tests.sh $(BUILD) $@

check-report: report ## check the page in a browser, its links and its spelling
	@verification/report/check.sh $(BUILD)

check-explore: explore ## check the page with the engine, compared with the program
	@verification/report/check.sh $(BUILD)

engine: # for the page
	@figures/make/packages.sh check deps && verification/report/engine/build.sh $(BUILD)

approve: ## rewrite approved texts and tables; read the change
	@$(build) verification && ROTOR_APPROVE=1 $(BUILD)/verification --gtest_brief=1 --gtest_filter='*Approved*' && git diff --stat

lint: ## check the format, and look for mistakes with clang-tidy
	@figures/make/packages.sh check deps && verification/lint.sh $(BUILD)

sanitize: ## run the tests with sanitizers
	@figures/make/build.sh $(BUILD)/sanitize --preset sanitize verification && \
	  verification/tests.sh $(BUILD)/sanitize verification $(call text,TESTS)

races: ## look for data races between the threads of a sweep
	@figures/make/build.sh $(BUILD)/races --preset races verify-threads && verification/races.sh $(BUILD)/races

portable: build ## build for another processor, and compare to the last bit
	@verification/program/portable.sh $(BUILD)

dist: explore figures maps ## make one archive: this commit, the page, figures and maps
	@figures/make/dist.sh $(BUILD) $(POINTS) $(FORMAT)

mutants: ## break the program in ways that tests must notice
	@figures/make/packages.sh check deps && verification/robustness/mutants.py --seed $(SEED) --hand $(HAND) --count $(COUNT) --under $(call text,UNDER)

bench-programs: ## build the programs of make bench, stress and reference
	@$(build) --with bench benchmark entries rotor random-rotors reference random-digits

bench: bench-programs ## measure run time and error of each method, and draw them
	@verification/benchmark/bench.sh $(BUILD)

score: ## right digits of an entry to reference-data/problems: make score FILE=entry.csv
	@verification/benchmark/score.py $(and $(FILE),$(call text,FILE))

stress: ## test 5,000 random rotors and estimated digits
	@$(build) random-rotors random-digits && verification/robustness/stress.sh $(BUILD) $(RUNS) $(SEED)

##
## What these need beyond make deps, such as make deps-lint:
deps-%: ## install those of deps-NAME in figures/make/packages.txt
	@figures/make/packages.sh install $@ deps

deps-report: deps
	@verification/report/install.sh $(BUILD)

##
## Options:
##   FORMAT=svg|pdf|png, EQUATIONS=published|corrected, FIG="3 4"    for figures
##   FORMAT=svg|pdf|png, POINTS=40 along each axis (default 400)     for maps, dist
##   CASES="mu 0.3": accidents with this in their names              for validate
##   RUNS=100, drawn with SEED=7, to 3, 6, 9 and 12 digits           for stress
##   FILE=entry.csv, with problem,quantity,value                     for score
##   PREFIX=/usr/local, the default                                  for install
##   TESTS="Contact*": tests with such names                         for sanitize
##   SEED=7 HAND=50 COUNT=100 UNDER="model figures": which changes   for mutants
##   CXX=clang++: another compiler, in build/clang++                 for all that is built
