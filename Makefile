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
ifeq ($(origin CC),default)
CC = gcc
endif
# users' own, which would change what tools read and say (scripts/auto/tools.sh)
export LC_ALL = C
unexport CDPATH POSIXLY_CORRECT
export MLG_BUILT = yes

# A layout is a models/ file that ends by including plugin.h.
layouts := $(patsubst models/%.c,%,$(shell grep -l '^#include "plugin.h"' models/*.c))
# by the shell alone: a name may be anything until it has been looked at
misnamed := $(shell grep -l '^\#include "plugin.h"' models/*.c | sed 's|^models/||; s|\.c$$||' | LC_ALL=C grep -vE '^[A-Za-z][A-Za-z0-9_]*$$')
ifneq ($(misnamed),)
$(error models/$(firstword $(misnamed)).c: the name of a layout has letters, digits and _, a letter first)
endif
models := $(layouts:%=build/models/%.exe) $(layouts:%=build/models/%.boundary.exe) \
          build/bin/mlg
# asked once, of what is built with it
sundials = $(eval sundials := $(shell CC="$(CC)" scripts/auto/sundials.sh))$(sundials)
lapack = -llapacke -llapack
numerics = $(lapack) $(sundials) -lm
runs := $(patsubst constants/c.l1.%,%,$(wildcard constants/c.l1.*))
made_constants := $(filter-out $(patsubst constants/c.%,%,$(wildcard constants/c.*)),\
                    $(foreach layout,$(layouts),$(runs:%=$(layout).%)))
models += $(made_constants:%=build/constants/c.%)
libraries := build/lib/libmlg.a build/lib/libmlg.so
goals := $(or $(MAKECMDGOALS),figures)
ifneq ($(if $(filter 0,$(MAKELEVEL)),$(filter-out help clean distclean,$(goals))),)
$(shell scripts/auto/sound.sh)
endif

.PHONY: figures page check-pages models libmlg drawings test fuzz test-programs check-scripts setup bench clean distclean help always

# Those whose stamps no longer hold; then those that were drawn from a table of several
# figures before the last of these had put in its rows.
figures: $(models) drawings ## every figure and the table of paper against computed values
	+@for pass in first second; do \
	  stale=$$(build/bin/mlg stamp fits $(figures)) && break; \
	  $(MAKE) --no-print-directory MLG_SET_UP=yes $$stale || exit; \
	done
	@scripts/report/collect.sh
	@scripts/report/targets.sh
	@scripts/report/page.sh

page: ## the results as one page, build/results.html, from the tables that are there
	@scripts/report/page.sh

models: $(models) ## the layouts as AUTO executables, build/models/*.exe

libmlg: $(libraries) ## the equations as a C library, build/lib (docs/libmlg.md)

setup: build/auto.mk ## packages and AUTO only

# --- AUTO-07p and the models ------------------------------------------------
# build/auto.mk says where AUTO is.  Including it makes it: make then starts
# over with what it says.
need_test_packages := prove mutants bench check-demos test% check-scripts verify study-check build/bin/eigen-%
export MLG_AUTO_GIVEN := $(value AUTO_DIR)
ifneq ($(filter-out help clean distclean test check-fresh libmlg build/lib/% build/bin/mlg drawings docs/drawings/%,$(goals)),)
include build/auto.mk
unexport AUTO_DIR
endif

build/auto.mk: $(if $(MLG_SET_UP),,always)
	@scripts/setup.sh $(if $(filter $(need_test_packages),$(goals)),test,figures)
	@AUTO_DIR="$$MLG_AUTO_GIVEN" scripts/auto/build-auto.sh

# What a command makes has a name of its own until it is whole: neither a second
# make in this tree nor an interrupted one leaves half a file behind.  What cannot be
# made leaves no old one to be taken for it.
# Its sum stands beside it, by which scripts/auto/sound.sh finds what was damaged since.
whole = { $(1) -o $@.$$$$ && mv $@.$$$$ $@ && $(noted); } || { rm -f $@ $@.$$$$; false; }
noted = { md5sum $@ $(basename $@).d > $@.sum 2> /dev/null || true; }
compiled = $(call whole,$(1) -MMD -MP -MT $@ -MF $(basename $@).d)

# What is the same for every layout is compiled once: gear.c, and boundary.c.
auto_cc = $(CC) $(CFLAGS) -isystem $(AUTO_INCLUDE) -c

build/models/gear.o: models/gear.c Makefile
	@mkdir -p $(@D)
	@$(call compiled,$(CC) $(CFLAGS) -fPIC -fvisibility=hidden -c $<)

build/models/boundary.o: models/boundary.c build/auto.mk Makefile
	@mkdir -p $(@D)
	@$(call compiled,$(auto_cc) -fcx-limited-range $<)

build/models/%.o: models/%.c build/auto.mk Makefile
	@mkdir -p $(@D)
	@echo "  $< -> build/models/$*.exe"
	@$(call compiled,$(auto_cc) -DMLG_APART $<)

# the device alone, for the algebraic problem of boundary.h
build/models/%.device.o: models/%.c Makefile
	@mkdir -p $(@D)
	@$(call compiled,$(CC) $(CFLAGS) -DMLG_BOUNDARY -c $<)

build/models/%.boundary.exe: build/models/%.device.o build/models/boundary.o
	@$(call whole,$(AUTO_FC) $^ $(AUTO_LINK))

build/models/%.exe: build/models/%.o build/models/gear.o
	@$(call whole,$(AUTO_FC) $^ $(AUTO_LINK))

# the constants files a layout lacks in constants/: those of L2, else of L1
define constants_rule
build/constants/c.$(1): $(firstword $(wildcard constants/c.l2$(suffix $(1)) constants/c.l1$(suffix $(1)))) build/bin/mlg
	@mkdir -p $$(@D)
	@{ echo "# $$<, made one for layout $(basename $(1)) by the Makefile"; \
	  build/bin/mlg constants $$< layout=$(basename $(1)); } > $$@.$$$$$$$$ && mv $$@.$$$$$$$$ $$@ && $$(noted)
endef
$(foreach file,$(made_constants),$(eval $(call constants_rule,$(file))))

# --- libmlg: the equations and what follows from them as a C library, without AUTO
library_cc = $(CC) $(CFLAGS) -fPIC -fvisibility=hidden -Imodels -Imodels/libmlg -Ibuild/libmlg -c
library_parts := $(patsubst models/libmlg/%.c,build/libmlg/%.o,$(filter-out %/layout.c,$(wildcard models/libmlg/*.c)))
library_layouts := $(layouts:%=build/libmlg/layout-%.o)

build/libmlg/layouts.h: always
	@mkdir -p $(@D)
	@printf 'L(%s)\n' $(layouts) > $@.$$$$ && if cmp -s $@.$$$$ $@; then rm $@.$$$$; else mv $@.$$$$ $@; fi

# those that include layouts.h say so in their .d; a new layout makes none of the others anew
$(library_parts): build/libmlg/%.o: models/libmlg/%.c Makefile | build/libmlg/layouts.h
	@$(call compiled,$(library_cc) $<)

$(library_layouts): build/libmlg/layout-%.o: models/libmlg/layout.c models/%.c Makefile
	@mkdir -p $(@D)
	@$(call compiled,$(library_cc) -DMLG_APART -DLAYOUT='"$*.c"' -DNAME=$* $<)

build/lib/libmlg.a: $(library_parts) $(library_layouts) build/models/gear.o
	@mkdir -p $(@D)
	@$(AR) rcs $@.$$$$ $^ && mv $@.$$$$ $@ && $(noted)

build/lib/libmlg.so: $(library_parts) $(library_layouts) build/models/gear.o
	@mkdir -p $(@D)
	@$(call whole,$(CC) -shared $^ $(numerics))

# --- mlg: the one command on it ------------------------------------------------
mlg_parts := $(patsubst scripts/mlg/%.c,build/mlg/%.o,$(filter-out %/drawn.c,$(wildcard scripts/mlg/*.c scripts/mlg/*/*.c)))
mlg_drawn := $(layouts:%=build/mlg/drawn-%.o)
mlg_includes = -Imodels -Imodels/libmlg -Ibuild/libmlg -Iscripts/mlg -Iscripts/mlg/gear -Iscripts/mlg/auto -Iscripts/mlg/report -Iscripts/mlg/sweep
# the work is in the library: the commands around it are compiled quickly
mlg_cc = $(CC) $(CFLAGS) -O1 $(mlg_includes) -c

$(mlg_parts): build/mlg/%.o: scripts/mlg/%.c Makefile | build/libmlg/layouts.h
	@mkdir -p $(@D)
	@$(call compiled,$(mlg_cc) $<)

# but for the sums of all files behind a run
build/mlg/auto/sums.o: mlg_cc += -O2

# a tree of names, for which any optimisation is too much
$(mlg_drawn): build/mlg/drawn-%.o: scripts/mlg/gear/drawn.c models/%.c Makefile
	@mkdir -p $(@D)
	@$(call compiled,$(mlg_cc) -O0 -DLAYOUT='"$*.c"' -DNAME=$* $<)

# Linked statically it starts in a third of the time, which a run that is up to date takes
# no longer than; where the static libraries are not there it goes without.
build/bin/mlg: $(mlg_parts) $(mlg_drawn) build/lib/libmlg.a
	@mkdir -p $(@D)
	@$(call whole,$(CC) -static $^ $(numerics) -lblas -lgfortran -lquadmath -lm) 2> /dev/null || { $(call whole,$(CC) $^ $(numerics)); }

-include $(wildcard build/models/*.d build/libmlg/*.d build/mlg/*.d build/mlg/*/*.d build/bin/*.d build/tests/*.d build/tests/libmlg/*.d)
.SECONDARY:

# --- figures: runs side by side, then tables, then the picture ---------------
# fig06.a is the part runs_a of scripts/fig06.sh.  A run remakes itself only when its
# inputs changed (mlg run), a figure when a file that it used did (mlg stamp).
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
parts_layouts := li3 li4 li5 li6 li7
parts_certify := l1 l2 li1 li2
parts_sections := past tori elsewhere
parts_sweeps := load map play hopf
parts_joints := cycles play planes friction thresholds dampers starts
parts_doubts := zB_shared R_moves heading I_p tyre
parts_networks := width small larger inertance
parts_passive := 180e3 200e3 220e3 any_180e3 any_200e3 any_220e3 fast gears
parts_design := own loads over_b largest tolerance map elasticities probability advice auto
studies := damping transients layouts certify sections sweeps joints doubts networks passive design

# A part of a figure's runs by itself, so that -j2 makes them side by side; the figure.
define figure_rules
.PHONY: $(1) $(parts_$(1):%=$(1).%)
$(parts_$(1):%=$(1).%): $(1).%: $$(models)
	@$(script_$(1)) runs $$*
$(1): $(parts_$(1):%=$(1).%)
	@$(script_$(1))
endef
$(foreach figure,$(figures),$(eval script_$(figure) = scripts/$(figure).sh))
$(foreach study,$(studies),$(eval script_$(study) = scripts/studies/$(study).sh))
$(foreach figure,$(figures) $(studies),$(eval $(call figure_rules,$(figure))))

fig07.hopf: fig06.a fig06.c
fig07.torus_psi_up fig07.torus_psi_down fig07.torus_delta filmstrip.orbits: fig06.a

# its diagram (a) is one of Figure 9, and L2 is LI2 at b = 0
fig10: fig09 fig15

$(parts_transients:%=transients.%): damping
$(parts_sections:%=sections.%): sections.branches
sections.branches: fig06.a
design.loads design.tolerance: design.own
design.elasticities design.probability design.advice: design.tolerance

networks.small: networks.width

export MLG_ASKED := $(or $(filter $(figures) $(studies),$(goals)),$(figures))
export MLG_STARTED := $(shell date +%s)

fig06: ## Figure 6: one-parameter diagrams in V, layout L1
fig07: ## Figure 7: the (V, c_d) plane, layout L1
fig09: ## Figure 9: Hopf curves for several k_s, layout L2
fig10: ## Figure 10: boundary points over k_s, layout L2
fig12: ## Figure 12: Hopf curves for several k_s and b, layout LI1
fig13: ## Figure 13: boundary points and largest width, layout LI1
fig14: ## Figure 14: Hopf curves for several k_s and b, layout LI2
fig15: ## Figure 15: zero-shimmy regions and largest width, layout LI2
filmstrip: ## solutions A and B of Figure 6 over a period: the gear from above and behind
layouts: ## layouts LI3 to LI7: diagrams, boundary points, widths (docs/layouts.md)
damping: ## least damping ratios of every layout, a minute (docs/damping.md)
transients: ## peaks and settling times after a disturbance, four minutes more (docs/damping.md)
networks: ## the best designs of every small network and the larger family, an hour and a half (docs/networks.md)
passive: ## the largest damping of any passive device, a quarter of an hour (docs/networks.md)
sections: ## what follows past the torus points of Figure 6 (docs/simulate.md)
sweeps: ## a million gears over load and tolerance, a map over (e, l), AUTO against the algebra; 15 minutes (docs/sweeps.md)
joints: ## play, friction and real dampers, half an hour of a processor (docs/joints.md)
doubts: ## what the results hang on: the model's choices, another tyre (docs/doubts.md)
design: ## designs under loads, tolerances and spreads, and advice (docs/design.md)
certify: ## do oscillations reach into the zero-shimmy regions? (docs/certification.md)

# --- drawings of the gear and of each layout, docs/drawings ------------------
drawings: $(layouts:%=docs/drawings/%.svg) docs/drawings/gear.svg ## docs/drawings: the gear and each layout's device

docs/drawings/gear.svg: build/bin/mlg
	@mkdir -p $(@D)
	@$< gear > build/$(@F) && mv build/$(@F) $@

docs/drawings/%.svg: build/bin/mlg models/%.c
	@mkdir -p $(@D)
	@$< draw $* > build/$(@F) && mv build/$(@F) $@

# --- tests -----------------------------------------------------------------
# One program for each tests/test_*.c; of test_layout.c one for each layout, and
# beside it the oracle tests/eigen.c. They include the model, and nothing of AUTO
# but its header.
tests := $(filter-out build/tests/layout,$(patsubst tests/test_%.c,build/tests/%,$(wildcard tests/test_*.c)))
layout_tests := $(layouts:%=build/tests/layout-%)
oracles := $(layouts:%=build/bin/eigen-%)
to_test = $(mlg_includes)
to_test_layout = $(to_test) -D_DEFAULT_SOURCE -isystem $(AUTO_INCLUDE) -DLAYOUT='"$*.c"'

test: ## every test; tests/run.sh runs some of them, and has them built
	+@MLG_BUILT= tests/run.sh

.PHONY: test-set-up
test-set-up: build/auto.mk

test-programs: $(models) build/bin/mlg $(libraries) $(tests) $(layout_tests) $(oracles)

check-pages: page ## the page and a study's in headless Chromium, at the widths of a phone and of a desk
	@scripts/setup.sh pages
	@bats tests/pages

.PHONY: check-demos
check-demos: models ## every figure as a demo by AUTO alone, minutes; MLG_AUTO_NEWEST=/path tries another
	@bats tests/demos

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

.PHONY: mutants
mutants: test-programs ## changes made on purpose, each of which a test has to notice; half an hour on one core
	@tests/mutants.sh

fuzz: build/tests/constants ## the constants checker on 10 million random inputs; SEED=2 for others
	FUZZ=10000000 build/tests/constants

.PHONY: check-fresh
check-fresh: ## both commands on bare Debian systems, as root and not; suite=trixie for one
	@case='$(case)' mirror='$(mirror)' tests/fresh.sh $(suite)

check-scripts: models ## shellcheck over every script and test
	@tests/run.sh scripts

$(tests): build/tests/%: tests/test_%.c build/auto.mk Makefile
	@mkdir -p $(@D)
	@echo "  $< -> $@"
	@$(call compiled,$(CC) $(TEST_CFLAGS) $(to_test) $< -lcmocka $(with) -lm)

# the library once more, to catch what it does wrong
checked_library := $(patsubst build/libmlg/%,build/tests/libmlg/%,$(library_parts) $(library_layouts))
checked_cc = $(CC) $(TEST_CFLAGS) -Imodels -Imodels/libmlg -Ibuild/libmlg -c

mlg_reader = $(patsubst %,scripts/mlg/auto/%.c,text autofile autonumber autostability autosolution branch ending judge judgehopf judgepoints sums)
build/tests/autofile: with = $(mlg_reader) build/tests/libmlg.a $(lapack)
build/tests/autofile: $(mlg_reader) $(wildcard scripts/mlg/*/*.h) build/tests/libmlg.a
mlg_constants = $(patsubst %,scripts/mlg/auto/%.c,text autonumber constants conchecks units)
build/tests/constants: with = $(mlg_constants) build/tests/libmlg.a
build/tests/constants: $(mlg_constants) scripts/mlg/auto/conparse.c scripts/mlg/gear/gearfile.c $(wildcard scripts/mlg/*/*.h) build/tests/libmlg.a

$(filter-out build/tests/libmlg/layout-%,$(checked_library)): build/tests/libmlg/%.o: models/libmlg/%.c Makefile | build/libmlg/layouts.h
	@mkdir -p $(@D)
	@$(call compiled,$(checked_cc) $<)

$(layouts:%=build/tests/libmlg/layout-%.o): build/tests/libmlg/layout-%.o: models/libmlg/layout.c models/%.c Makefile
	@mkdir -p $(@D)
	@$(call compiled,$(checked_cc) -DMLG_APART -DLAYOUT='"$*.c"' -DNAME=$* $<)

build/tests/libmlg/gear.o: models/gear.c Makefile
	@mkdir -p $(@D)
	@$(call compiled,$(checked_cc) $<)

build/tests/libmlg.a: $(checked_library) build/tests/libmlg/gear.o
	@$(AR) rcs $@.$$$$ $^ && mv $@.$$$$ $@

mlg_passive = $(patsubst %,scripts/mlg/gear/%.c,positive_real bfgs)
build/tests/positive_real: with = $(mlg_passive) build/tests/libmlg.a $(lapack)
build/tests/positive_real: $(mlg_passive) $(wildcard scripts/mlg/*/*.h) build/tests/libmlg.a

build/tests/integrate build/tests/criticality: with = build/tests/libmlg.a $(lapack) $(sundials)
build/tests/integrate build/tests/criticality: build/tests/libmlg.a
build/tests/climb: with = build/tests/libmlg.a
build/tests/climb: build/tests/libmlg.a

# compiled in an eighth of the time, and hardly slower
$(layout_tests): build/tests/layout-%: tests/test_layout.c models/%.c build/tests/libmlg.a build/auto.mk Makefile
	@mkdir -p $(@D)
	@echo "  $< -> $@"
	@$(call compiled,$(CC) $(TEST_CFLAGS) -O0 $(to_test_layout) $< build/tests/libmlg.a -lcmocka $(lapack) -lm)

$(oracles): build/bin/eigen-%: tests/eigen.c models/%.c build/auto.mk Makefile
	@mkdir -p $(@D)
	@echo "  $< -> $@"
	@$(call compiled,$(CC) $(CFLAGS) $(to_test_layout) $< $(lapack) -lm)

# --- proof of completeness: random gears against tests/random/oracle.c ----------
# The oracle shares nothing with the library; random-compare links the library.
random := $(wildcard tests/random/*.h) $(addprefix tests/random/,matrix.c oracle.c samples.c gears.c)
random_cc = $(call compiled,$(CC) $(CFLAGS) -Imodels -Imodels/libmlg $(filter %.c %.a,$^) $(numerics))

build/bin/random-oracle: tests/random/table.c $(random) Makefile
	@mkdir -p $(@D)
	@$(random_cc)

build/bin/random-compare: tests/random/compare.c $(random) build/lib/libmlg.a Makefile
	@mkdir -p $(@D)
	@$(random_cc)

test-programs: build/bin/random-oracle build/bin/random-compare

.PHONY: study-check
study-check: $(models) build/bin/eigen-l1 build/bin/eigen-li2 ## studies of 10 random gears (gears=30 for more) against the eigenvalues
	@tests/study/random.sh $(or $(gears),10)

.PHONY: prove
prove: build/bin/random-compare build/bin/random-oracle ## 2000 random gears, all layouts, against the oracle; three minutes on two cores
	@build/bin/random-compare hard tests/random/hard.csv
	@build/bin/random-compare units 100
	@build/bin/random-compare 1000 first=1000 2> /dev/null & other=$$!; \
	  build/bin/random-compare 1000; status=$$?; wait $$other && exit $$status

clean: ## the runs and the models; AUTO and its tarball stay
	rm -rf build/runs build/tables build/constants build/models build/lib build/libmlg build/mlg build/bin build/tests

distclean: ## everything that was built
	rm -rf build

help: ## this list
	@awk -F ':.*## ' '/^[a-z0-9_-]+:.*## / { printf "  make %-13s %s\n", $$1, $$2 }' Makefile

always:
