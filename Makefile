# Zero-shimmy regions of an aircraft main landing gear with AUTO-07p.
#   make          every figure and the table of paper against computed values
#   make test     every test
#   make help     the other targets
# AUTO_DIR=/path uses an AUTO-07p that is there; AUTO_TARBALL=file builds from
# that tarball; otherwise AUTO is fetched and built in build/auto.

# -Werror goes with the tests alone: a newer compiler has warnings of its own.  Other
# CFLAGS leave C11 in force, for auto_f2c.h does not go with the C23 of newer ones.
CFLAGS = -O2 -Wall -Wextra -Wpedantic $(if $(filter test% check%,$(goals)),-Werror)
override CFLAGS += -std=c11
TEST_CFLAGS = -O1 -g -std=c11 -Wall -Wextra -Wpedantic -Werror -fsanitize=address,undefined \
              -fno-sanitize-recover=all
SHELL = /bin/bash
export MLG_BUILT = yes

# A layout is a models/ file that ends by including plugin.h.
layouts := $(patsubst models/%.c,%,$(shell grep -l '^#include "plugin.h"' models/*.c))
misnamed := $(shell printf '%s\n' $(layouts) | grep -vE '^[A-Za-z][A-Za-z0-9_]*$$')
ifneq ($(misnamed),)
$(error models/$(firstword $(misnamed)).c: the name of a layout has letters, digits and _, a letter first)
endif
models := $(layouts:%=build/models/%.exe) $(layouts:%=build/models/%.boundary.exe) \
          $(layouts:%=build/bin/scan-%) $(layouts:%=build/bin/curves-%) build/bin/constants
damped := damping transients
integrating := simulate search
sundials = -lsundials_cvode -lsundials_nvecserial
lapack = -llapacke -llapack
runs := $(patsubst constants/c.l1.%,%,$(wildcard constants/c.l1.*))
made_constants := $(filter-out $(patsubst constants/c.%,%,$(wildcard constants/c.*)),\
                    $(foreach layout,$(layouts),$(runs:%=$(layout).%)))
models += $(made_constants:%=build/constants/c.%)
libraries := build/lib/libmlg.a build/lib/libmlg.so
goals := $(or $(MAKECMDGOALS),figures)

.PHONY: figures page check-pages models libmlg collect drawings test fuzz test-programs check-scripts setup bench clean distclean help always

figures: ## every figure and the table of paper against computed values
	@scripts/targets.sh
	@scripts/summary.sh
	@scripts/page.sh

page: ## the results as one page, build/results.html, from the tables that are there
	@scripts/summary.sh
	@scripts/page.sh

models: $(models) ## the layouts as AUTO executables, build/models/*.exe

libmlg: $(libraries) ## the equations as a C library, build/lib (docs/libmlg.md)

setup: build/auto.mk ## packages and AUTO only

# --- AUTO-07p and the models ------------------------------------------------
# build/auto.mk says where AUTO is.  Including it makes it: make then starts
# over with what it says.
need_test_packages := bench sections test% check-scripts certify% verify $(damped) $(foreach study,$(damped),$(study).% build/bin/$(study)-%) $(integrating) $(integrating:%=build/bin/%-%)
auto_given := $(AUTO_DIR)
ifneq ($(filter-out help clean distclean libmlg build/lib/% drawings docs/drawings/%,$(goals)),)
include build/auto.mk
unexport AUTO_DIR
endif

build/auto.mk: always
	@scripts/setup.sh $(if $(filter $(need_test_packages),$(goals)),test,figures)
	@AUTO_DIR='$(auto_given)' scripts/build-auto.sh

# What a command makes has a name of its own until it is whole: neither a second
# make in this tree nor an interrupted one leaves half a file behind.
whole = $(1) -o $@.$$$$ && mv $@.$$$$ $@
compiled = $(call whole,$(1) -MMD -MP -MT $@ -MF $(basename $@).d)

build/models/%.o: models/%.c build/auto.mk Makefile
	@mkdir -p $(@D)
	@echo "  $< -> build/models/$*.exe"
	@$(call compiled,$(CC) $(CFLAGS) -isystem $(AUTO_INCLUDE) -c $<)

# the algebraic problem of boundary.h around the same device; -O3 halves its time,
# which is sums and products of polynomials
build/models/%.boundary.o: models/%.c build/auto.mk Makefile
	@mkdir -p $(@D)
	@$(call compiled,$(CC) $(CFLAGS) -O3 -fcx-limited-range -DMLG_BOUNDARY -isystem $(AUTO_INCLUDE) -c $<)

# programs that need no AUTO, around the same device
define tool_rule
build/bin/$(1)-%: scripts/$(1).c models/%.c Makefile
	@mkdir -p $$(@D)
	@$$(call compiled,$$(CC) $$(CFLAGS) -fcx-limited-range -Imodels -DLAYOUT='"$$*.c"' $$< $(2) -lm)
endef
$(foreach tool,scan curves draw,$(eval $(call tool_rule,$(tool))))

# programs on scripts/damping.h
$(eval $(call tool_rule,damping,$(lapack)))
$(eval $(call tool_rule,transients,$(lapack) $(sundials)))

# programs on scripts/integrate.h
$(foreach tool,$(integrating),$(eval $(call tool_rule,$(tool),$(sundials))))

.PHONY: simulate sections
sections: simulate $(models) ## what follows past the torus points of Figure 6 (docs/simulate.md)
	@scripts/sections.sh

simulate: $(layouts:%=build/bin/simulate-%) ## layouts in time from any start, build/bin/simulate-* (docs/simulate.md)

build/models/%.exe: build/models/%.o
	@$(call whole,$(AUTO_FC) $< $(AUTO_LINK))

build/bin/gear: scripts/gear.c Makefile
	@mkdir -p $(@D)
	@$(call compiled,$(CC) $(CFLAGS) $< -lm)

build/bin/constants: scripts/constants.c build/lib/libmlg.a Makefile
	@mkdir -p $(@D)
	@$(call compiled,$(CC) $(CFLAGS) $< build/lib/libmlg.a -lm)

# Linked statically it starts in a third of the time, which a run that is up to date
# takes no longer than; where the static libraries are not there it goes without.
build/bin/mlg: $(wildcard scripts/mlg/*.[ch]) build/lib/libmlg.a Makefile
	@mkdir -p $(@D)
	@$(call whole,$(CC) $(CFLAGS) -static $(filter %.c,$^) build/lib/libmlg.a $(lapack) -lblas -lgfortran -lquadmath -lm) 2> /dev/null \
	|| { $(call whole,$(CC) $(CFLAGS) $(filter %.c,$^) build/lib/libmlg.a $(lapack) -lm); }

# the constants files a layout lacks in constants/: those of L2, else of L1
define constants_rule
build/constants/c.$(1): $(firstword $(wildcard constants/c.l2$(suffix $(1)) constants/c.l1$(suffix $(1)))) build/bin/constants
	@mkdir -p $$(@D)
	@{ echo "# $$<, made one for layout $(basename $(1)) by the Makefile"; \
	  build/bin/constants $$< layout=$(basename $(1)); } > $$@.$$$$$$$$ && mv $$@.$$$$$$$$ $$@
endef
$(foreach file,$(made_constants),$(eval $(call constants_rule,$(file))))

# --- libmlg: the right-hand sides as a C library, without AUTO ----------------
library_cc = $(CC) $(CFLAGS) -fPIC -fvisibility=hidden -Imodels -Ibuild/lib -c

build/lib/layouts.h: always
	@mkdir -p $(@D)
	@printf 'L(%s)\n' $(layouts) > $@.$$$$ && if cmp -s $@.$$$$ $@; then rm $@.$$$$; else mv $@.$$$$ $@; fi

build/lib/libmlg.o: models/libmlg.c build/lib/layouts.h Makefile
	@$(call compiled,$(library_cc) $<)

build/lib/%.o: models/libmlg_layout.c models/%.c Makefile
	@mkdir -p $(@D)
	@$(call compiled,$(library_cc) -DLAYOUT='"$*.c"' -DNAME=$* $<)

build/lib/libmlg.a: build/lib/libmlg.o $(layouts:%=build/lib/%.o)
	@$(AR) rcs $@.$$$$ $^ && mv $@.$$$$ $@

build/lib/libmlg.so: build/lib/libmlg.o $(layouts:%=build/lib/%.o)
	@$(call whole,$(CC) -shared $^ -lm)

-include $(wildcard build/models/*.d build/lib/*.d build/bin/*.d build/tests/*.d)
.SECONDARY:

# --- figures: runs side by side, then tables, then the picture ---------------
# A run remakes itself only when its inputs changed, so these targets are
# always asked and seldom work.  fig06.a is the part runs_a of scripts/fig06.sh.
parts_fig06 := a b c
parts_fig07 := hopf torus_psi_up torus_psi_down torus_delta
parts_fig09 := a b
parts_fig10 := l2
parts_fig12 := b20_30 b70_100 b130_150
parts_fig13 := low high widths
parts_fig14 := b50 b100
parts_fig15 := low high widths
parts_filmstrip := orbits
figures := fig06 fig07 fig09 fig10 fig12 fig13 fig14 fig15 filmstrip

# beyond the paper, and not part of make figures
parts_damping := planes search
parts_transients := paper best
parts_layouts := li3 li4 li5
parts_certify := l1 l2 li1 li2
studies := $(damped) layouts certify

define figure_rules
.PHONY: $(1) $(1).tables $(parts_$(1):%=$(1).%)
$(parts_$(1):%=$(1).%): $(1).%: $$(models)
	@scripts/$(1).sh runs $$*
$(1).tables: $(parts_$(1):%=$(1).%)
	@scripts/$(1).sh tables
$(1): collect
	@scripts/$(1).sh draw
endef
$(foreach figure,$(figures) $(studies),$(eval $(call figure_rules,$(figure))))

figures: $(figures) drawings
fig07.hopf: fig06.a fig06.c
fig07.torus_psi_up fig07.torus_psi_down fig07.torus_delta filmstrip.orbits: fig06.a

# its diagram (a) is one of Figure 9
fig10: fig09.tables

$(parts_damping:%=damping.%): $(layouts:%=build/bin/damping-%)
$(parts_transients:%=transients.%): damping.tables $(layouts:%=build/bin/transients-%)
$(parts_certify:%=certify.%): $(foreach tool,eigen search,$(layouts:%=build/bin/$(tool)-%))

# what the figures share, of those asked for
asked := $(filter $(figures) $(studies),$(goals))
export MLG_ASKED := $(or $(asked),$(figures))
export MLG_STARTED := $(shell date +%s)
collect: $(addsuffix .tables,$(or $(asked),$(figures)))
	@scripts/collect.sh

fig06: ## Figure 6: one-parameter diagrams in V, layout L1
fig07: ## Figure 7: the (V, c_d) plane, layout L1
fig09: ## Figure 9: Hopf curves for several k_s, layout L2
fig10: ## Figure 10: boundary points over k_s, layout L2
fig12: ## Figure 12: Hopf curves for several k_s and b, layout LI1
fig13: ## Figure 13: boundary points and largest width, layout LI1
fig14: ## Figure 14: Hopf curves for several k_s and b, layout LI2
fig15: ## Figure 15: zero-shimmy regions and largest width, layout LI2
filmstrip: ## solutions A and B of Figure 6 over a period: the gear from above and behind
layouts: ## layouts LI3, LI4 and LI5: diagrams, boundary points, widths (docs/layouts.md)
damping: ## least damping ratios of every layout, a minute or two (docs/damping.md)
transients: ## peaks and settling times after a disturbance, four minutes more (docs/damping.md)
certify: ## do oscillations reach into the zero-shimmy regions? (docs/certification.md)

# --- drawings of the gear and of each layout, docs/drawings ------------------
drawings: $(layouts:%=docs/drawings/%.svg) docs/drawings/gear.svg ## docs/drawings: the gear and each layout's device

docs/drawings/gear.svg: build/bin/gear
	@mkdir -p $(@D)
	@$< > build/$(@F) && mv build/$(@F) $@

docs/drawings/%.svg: build/bin/draw-%
	@mkdir -p $(@D)
	@$< > build/$(@F) && mv build/$(@F) $@

# --- tests -----------------------------------------------------------------
# One program for each tests/test_*.c; of test_layout.c one for each layout, and
# beside it the oracle tests/eigen.c. They include the model, and nothing of AUTO
# but its header.
tests := $(filter-out build/tests/layout,$(patsubst tests/test_%.c,build/tests/%,$(wildcard tests/test_*.c)))
layout_tests := $(layouts:%=build/tests/layout-%)
oracles := $(layouts:%=build/bin/eigen-%)
to_test = -Imodels -Iscripts
to_test_layout = $(to_test) -D_DEFAULT_SOURCE -isystem $(AUTO_INCLUDE) -DLAYOUT='"$*.c"'

test: test-programs ## every test; tests/run.sh runs some of them
	@tests/run.sh

test-programs: $(models) build/bin/mlg $(libraries) $(tests) $(layout_tests) $(oracles) \
               $(foreach tool,draw $(damped),$(layouts:%=build/bin/$(tool)-%)) build/bin/gear \
               $(foreach tool,$(integrating),$(layouts:%=build/bin/$(tool)-%))

check-pages: page ## the page in headless Chromium, at the widths of a phone and of a desk
	@scripts/setup.sh pages
	@bats tests/pages

# Times beside others; tests/bench/bench.sh PART... makes some of them.
benches := $(layouts:%=build/bench/rhs-%)

bench: test-programs $(benches) ## times beside other tools and earlier states (docs/performance.md)
	@tests/bench/bench.sh

$(benches): build/bench/rhs-%: tests/bench/rhs.c models/%.c build/auto.mk Makefile
	@mkdir -p $(@D)
	@$(call compiled,$(CC) $(CFLAGS) $(to_test_layout) $< -lm)

.PHONY: verify
verify: test-programs ## AUTO's values against oracles that do without AUTO
	@tests/verify.sh

fuzz: build/tests/fuzz ## the constants checker on 10 million random inputs; SEED=2 for others
	FUZZ=10000000 build/tests/fuzz

check-scripts: models ## shellcheck over every script and test
	@tests/run.sh scripts

$(tests): build/tests/%: tests/test_%.c build/auto.mk Makefile
	@mkdir -p $(@D)
	@echo "  $< -> $@"
	@$(call compiled,$(CC) $(TEST_CFLAGS) $(to_test) $< -lcmocka $(with) -lm)

build/tests/integrate: with = $(sundials)
build/tests/criticality: with = $(lapack)
mlg_reader = $(patsubst %,scripts/mlg/%.c,text autofile autonumber autostability autosolution branch ending judge judgepoints sums)
build/tests/autofile: with = $(mlg_reader) build/lib/libmlg.a $(lapack)
build/tests/autofile: $(mlg_reader) $(wildcard scripts/mlg/*.h) build/lib/libmlg.a
mlg_constants = $(patsubst %,scripts/mlg/%.c,text autonumber constants conchecks)
build/tests/constants: with = $(mlg_constants) build/lib/libmlg.a
build/tests/constants: $(mlg_constants) scripts/mlg/conparse.c $(wildcard scripts/mlg/*.h) build/lib/libmlg.a
build/tests/fuzz: with = build/lib/libmlg.a
build/tests/fuzz: build/lib/libmlg.a

$(layout_tests): build/tests/layout-%: tests/test_layout.c models/%.c build/lib/libmlg.a build/auto.mk Makefile
	@mkdir -p $(@D)
	@echo "  $< -> $@"
	@$(call compiled,$(CC) $(TEST_CFLAGS) $(to_test_layout) $< build/lib/libmlg.a -lcmocka $(lapack) -lm)

$(oracles): build/bin/eigen-%: tests/eigen.c models/%.c build/auto.mk Makefile
	@mkdir -p $(@D)
	@echo "  $< -> $@"
	@$(call compiled,$(CC) $(CFLAGS) $(to_test_layout) $< $(lapack) -lm)

clean: ## the runs and the models; AUTO and its tarball stay
	rm -rf build/runs build/tables build/constants build/models build/lib build/bin build/tests

distclean: ## everything that was built
	rm -rf build

help: ## this list
	@awk -F ':.*## ' '/^[a-z0-9_-]+:.*## / { printf "  make %-13s %s\n", $$1, $$2 }' Makefile

always:
