# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# Builds both libraries, the demo and the tests; `make help` lists the targets. Everything built goes under $(BUILD).
# The lists of sources are shared with CMakeLists.txt: src/sources.list, ports/desktop/demo.list, tests/unit/tests.list,
# tests/host/tests.list, tests/stability/tests.list, tests/bench/bench.list. Works with GNU make 3.81 and later.

## Variables:
##   PREFIX=/usr/local  DESTDIR=   where install puts things; LIBDIR=lib is a name below PREFIX
##   CC=cc  CXX=c++  AR=ar  NM=nm  the tools
##   CFLAGS=-O2                    your flags; those that the code needs are added to them
##   V=1                           show whole commands
##   WERROR=-Werror                warnings become errors (the tests do so)
##   ARGS="--autopilot"            options of the demo or of shapes: make demo ARGS=--help
##   IN=rock.png  OUT=rock.h       for shapes: the picture, sheet or map, and the header to write
##   UNITY_DIR=build/unity         the Unity test framework, a folder that holds src/unity.c; fetched if it is not there
##   TUFF_TEST_SCALE=100           percent of the random cases of the host tests

BUILD     ?= build
PREFIX    ?= /usr/local
LIBDIR    ?= lib
NM        ?= nm
INSTALL   ?= install
PYTHON    ?= python3
CFLAGS    ?= -O2
CXXFLAGS  ?= -O2
WERROR    ?=
UNITY_DIR ?= $(BUILD)/unity
ARGS      ?=

# ---- Flags. float: a contracted multiply-add would round differently on machines that have one.

WARNINGS := -Wall -Wextra -Wconversion -Wsign-conversion -Wdouble-promotion -Wshadow -pedantic
CODE     := -std=c99 -ffp-contract=off -ffunction-sections -fdata-sections
C_FLAGS   = $(CODE) $(WARNINGS) $(WERROR) -MMD -MP -Iinclude
CXX_FLAGS = -std=c++11 -Wall -Wextra -Wshadow -pedantic $(WERROR) -MMD -MP
DEMO      := -D_POSIX_C_SOURCE=200809L -Iports/scene -Iports/desktop
SANITIZE  := -O1 -g -fno-omit-frame-pointer -fno-sanitize-recover=all \
             -fsanitize=address,undefined,float-cast-overflow,float-divide-by-zero

SCALARS      := float q16
SCALAR_float := -DTUFF_SCALAR=TUFF_FLOAT
SCALAR_q16   := -DTUFF_SCALAR=TUFF_Q16_16

# ---- Lists; a line that begins with # is a comment.

lines = $(shell test -f $(1) && sed -e 's/\#.*//' $(2) $(1))

SOURCES    := $(call lines,src/sources.list)
DEMO_BOTH  := $(call lines,ports/desktop/demo.list,-n -e 's/^both //p')
DEMO_ONCE  := $(call lines,ports/desktop/demo.list,-n -e 's/^once //p')
UNIT_TESTS := $(call lines,tests/unit/tests.list)
HOST_TESTS := $(call lines,tests/host/tests.list,-n -e 's/^each //p')
HOST_ONCE  := $(call lines,tests/host/tests.list,-n -e 's/^once //p')
HOST_HELP  := $(filter-out $(patsubst %,tests/host/%.c,$(HOST_TESTS) $(HOST_ONCE)),$(wildcard tests/host/*.c))
HOST_CXX   := $(wildcard tests/host/*.cpp)
STABILITY_TESTS := $(call lines,tests/stability/tests.list)
STABILITY_HELP  := $(filter-out $(STABILITY_TESTS:%=tests/stability/%.c),$(wildcard tests/stability/*.c)) tests/bench/textbook.c \
                   $(filter ports/scene/%,$(DEMO_BOTH))
STABILITY_CXX   := $(wildcard tests/stability/*.cpp)

version = $(shell sed -n 's/^.define TUFF_VERSION_$(1)  *//p' include/tuff/tuff.h)
VERSION := $(call version,MAJOR).$(call version,MINOR).$(call version,PATCH)

LIBRARIES := $(SCALARS:%=$(BUILD)/libtuff-%.a)

SHAPE_TOOLS := $(BUILD)/shape-tools
SHAPES      := PYTHONPATH=tools/shapes $(SHAPE_TOOLS)/bin/python -m tuff_shapes

# ---- Targets that people call

.PHONY: all demo demo-program test bench bench-program gate-program cycles bench-models chart stability picture targets size rom rom-program rom-picture single shapes shape-tools rocks-draw install help clean
.PHONY: check-symbols FORCE
.DELETE_ON_ERROR:
.SECONDARY:

all: $(LIBRARIES) ## build both libraries (the default)

demo: demo-program ## build and play the demo in this terminal; ARGS="..." passes options
	@$(BUILD)/tuff-demo $(ARGS)

demo-program: $(BUILD)/tuff-demo ## build the demo only: build/tuff-demo

test: ## get what the tests need (says what it installs), build and run all of them
	@MAKE='$(MAKE_COMMAND)' CC='$(CC)' CXX='$(CXX)' NM='$(NM)' UNITY_DIR='$(abspath $(UNITY_DIR))' scripts/run-tests

bench: ## measure speed and accuracy against Box2D, Chipmunk2D and the textbook: build/bench/*.csv and a table
	@MAKE='$(MAKE_COMMAND)' CC='$(CC)' CXX='$(CXX)' BUILD='$(BUILD)' scripts/run-bench

bench-program: $(BUILD)/tuff-bench ## build the bench program only: build/tuff-bench

gate-program: $(BUILD)/tuff-gate

cycles: ## count cycles and instructions on the machines of ports: build/cycles.csv and tables
	@MAKE='$(MAKE_COMMAND)' CC='$(CC)' CXX='$(CXX)' scripts/run-cycles

bench-models: $(SHAPE_TOOLS)/ready ## measure what models of an outline cost and buy: build/bench/models.csv (Python 3.11)
	@scripts/get-bench-tools
	@$(MAKE) --no-print-directory CFLAGS=-O2 $(BUILD)/bench-models
	@PYTHONPATH=tools/shapes $(SHAPE_TOOLS)/bin/python tests/bench/models.py $(BUILD)/bench-models $(ROCKS) $(BUILD)/bench/models.csv

chart: $(SHAPE_TOOLS)/ready ## draw docs/charts from the tables that bench, bench-models and cycles made (Python 3.11)
	@$(SHAPE_TOOLS)/bin/python tests/bench/chart.py $(BUILD)/bench docs/charts

check-symbols: $(LIBRARIES) ## show that the libraries hold no mutable data, and the fixed one no float
	@NM='$(NM)' CC='$(CC)' scripts/check-symbols $(BUILD)

stability: $(SHAPE_TOOLS)/ready ## run the stability tests, redraw the pictures and the table of docs/stability.md (Python 3.11)
	@scripts/get-test-tools
	@$(MAKE) --no-print-directory stability-plain
	@$(SHAPE_TOOLS)/bin/python tests/stability/page.py write $(BUILD) docs/stability.md

picture: $(BUILD)/tuff-demo $(BUILD)/picture-tools/ready ## draw docs/demo.gif and the screenshots (Python 3, Pillow)
	$(BUILD)/picture-tools/bin/python ports/desktop/picture.py $(BUILD)/tuff-demo

shapes: $(SHAPE_TOOLS)/ready ## trace a picture into a header: make shapes IN=rock.png OUT=rock.h (Python 3.11)
	@$(SHAPES) $(ARGS) $(if $(IN),'$(IN)') $(if $(OUT),-o '$(OUT)')

shape-tools: $(SHAPE_TOOLS)/ready ## get what shapes needs, into build/shape-tools

rocks-draw: $(SHAPE_TOOLS)/ready ## draw the pictures of the demo's rocks anew: ports/scene/rocks
	$(SHAPE_TOOLS)/bin/python ports/scene/rocks/draw.py

targets: ## run the unit tests and the golden replay on all machines of ports/machines, in their emulators: build/targets.csv; one alone: make target-gba
	@MAKE='$(MAKE_COMMAND)' UNITY_DIR='$(abspath $(UNITY_DIR))' scripts/run-targets

MACHINES := $(patsubst ports/machines/%.mk,%,$(wildcard ports/machines/*.mk))
.PHONY: $(MACHINES:%=target-%)
$(MACHINES:%=target-%): target-%:
	@MAKE='$(MAKE_COMMAND)' UNITY_DIR='$(abspath $(UNITY_DIR))' scripts/run-target $*

size: ## measure code, RAM and stack on each machine by feature set: build/size.csv and a table (gets compilers)
	@MAKE='$(MAKE_COMMAND)' scripts/print-size

rom: rom-program ## build the demo as a Game Boy Advance ROM: build/tuff.gba
	@arm-none-eabi-size -A $(BUILD)/rom/tuff.elf | awk '/^\.(iwram|text|data|bss|ewram)/ { printf "%s %s  ", $$1, $$2 } END { print "bytes" }'

rom-program: FORCE
	@scripts/get-target-tools gba
	@$(MAKE) --no-print-directory -s -f ports/gba/rom/rom.mk OUT=$(BUILD)/rom ROM=$(BUILD)/tuff.gba $(BUILD)/tuff.gba $(BUILD)/rom/run

rom-picture: rom-program $(BUILD)/picture-tools/ready ## draw the ROM's screenshots, docs/gba-*.png (Python 3, Pillow)
	$(BUILD)/picture-tools/bin/python ports/gba/rom/picture.py $(BUILD)/rom/run $(BUILD)/tuff.gba

single: ## write the whole library as two files: build/single/tuff.h and tuff.c
	@scripts/make-single $(BUILD)/single

install: $(LIBRARIES) ## install headers, libraries, pkg-config files and CMake package: PREFIX, DESTDIR
	$(INSTALL) -d '$(DESTDIR)$(PREFIX)/include/tuff' '$(DESTDIR)$(PREFIX)/$(LIBDIR)/pkgconfig' '$(DESTDIR)$(PREFIX)/$(LIBDIR)/cmake/tuff'
	$(INSTALL) -m 644 include/tuff/*.h '$(DESTDIR)$(PREFIX)/include/tuff'
	$(INSTALL) -m 644 $(LIBRARIES) '$(DESTDIR)$(PREFIX)/$(LIBDIR)'
	$(call package_file,tuff-float.pc.in) > '$(DESTDIR)$(PREFIX)/$(LIBDIR)/pkgconfig/tuff-float.pc'
	$(call package_file,tuff-q16.pc.in) > '$(DESTDIR)$(PREFIX)/$(LIBDIR)/pkgconfig/tuff-q16.pc'
	$(call package_file,tuff-config.cmake.in) > '$(DESTDIR)$(PREFIX)/$(LIBDIR)/cmake/tuff/tuff-config.cmake'
	$(call package_file,tuff-config-version.cmake.in) > '$(DESTDIR)$(PREFIX)/$(LIBDIR)/cmake/tuff/tuff-config-version.cmake'

help: ## show this text
	@sed -n 's/^## \{0,1\}//p' Makefile
	@echo
	@echo 'Targets:'
	@sed -n 's/^\([a-z][a-z-]*\):.*## \(.*\)/\1|\2/p' Makefile | while IFS='|' read -r name text; do printf '  %-15s %s\n' "$$name" "$$text"; done

clean: ## remove everything that was built
	rm -rf '$(BUILD)'

# The installed files find each other by relative paths, so that the installed tree may be moved.
package_file = sed -e 's|@TUFF_VERSION@|$(VERSION)|g' -e 's|@TUFF_LIBDIR@|$(LIBDIR)|g' -e 's|@TUFF_INCLUDEDIR@|include|g' \
    -e "s|@TUFF_UP@|$$(echo '$(LIBDIR)' | sed 's,[^/][^/]*,..,g')|g" cmake/$(1)

# ---- Objects: $(BUILD)/make/<plain or sanitized>/<float, q16 or once>/<path>.o

# Rewritten when the flags differ from the last time, which rebuilds what depends on them.
FLAGS_NOW = $(CC) $(CXX) $(CFLAGS) $(CXXFLAGS) $(CPPFLAGS) $(WERROR) $(CODE) $(WARNINGS) $(SANITIZE)
$(BUILD)/make/flags: FORCE
	@mkdir -p $(@D)
	@printf '%s\n' '$(subst ','\'',$(FLAGS_NOW))' | cmp -s - $@ || printf '%s\n' '$(subst ','\'',$(FLAGS_NOW))' > $@

VARIANT_plain     := $(CFLAGS)
VARIANT_sanitized := $(SANITIZE)

V ?=
Q := $(if $(V),,@)
quiet := $(findstring s,$(firstword -$(MAKEFLAGS)))
say = @$(if $(V)$(quiet),:,printf '  %-4s %s\n' $(1) $(2))

# $(call objects,variant,scalar,sources)
objects = $(patsubst %,$(BUILD)/make/$(1)/$(2)/%.o,$(basename $(3)))

# $(call compile,variant,scalar,folder,flags): the rule for all C files below folder
define compile
$(BUILD)/make/$(1)/$(2)/$(3)/%.o: $(3)/%.c $(BUILD)/make/flags
	@mkdir -p $$(@D)
	$$(call say,CC,$$@)
	$$(Q)$$(CC) $$(CPPFLAGS) $$(VARIANT_$(1)) $$(C_FLAGS) $(SCALAR_$(2)) $(4) -c $$< -o $$@
endef

# $(call compile_cxx,variant,folder): the rule for all C++ files below folder, which are not compiled for one scalar
define compile_cxx
$(BUILD)/make/$(1)/once/$(2)/%.o: $(2)/%.cpp $(BUILD)/make/flags
	@mkdir -p $$(@D)
	$$(call say,CXX,$$@)
	$$(Q)$$(CXX) $$(CPPFLAGS) $$(CXXFLAGS) $$(if $$(filter sanitized,$(1)),$$(SANITIZE)) $$(CXX_FLAGS) $(HOST_FLAGS) -c $$< -o $$@
endef

# $(call archive,file,objects,list): made anew when the list, or the folder, has changed
define archive
$(1): $(2) $(3)
	@mkdir -p $$(@D)
	@rm -f $$@
	$$(call say,AR,$$@)
	$$(Q)$$(AR) rcs $$@ $(2)
endef

library = $(if $(filter plain,$(1)),$(BUILD)/libtuff-$(2).a,$(BUILD)/make/$(1)/libtuff-$(2).a)

# Older Unity reads no configuration file by itself.
UNITY_CONFIG := -include tests/unit/unity_config.h
UNIT_FLAGS := $(UNITY_CONFIG) -Itests/unit -Isrc -isystem $(UNITY_DIR)/src
HOST_FLAGS := -Itests/host
STABILITY_FLAGS := $(HOST_FLAGS) -Itests/bench -Iports/scene

# $(call build,variant,scalar)
define build
$(call compile,$(1),$(2),src,-Isrc)
$(call compile,$(1),$(2),ports,$(DEMO))
$(call compile,$(1),$(2),tests/unit,$(UNIT_FLAGS))
$(call compile,$(1),$(2),tests/host,$(HOST_FLAGS))
$(call compile,$(1),$(2),tests/bench,$(HOST_FLAGS) -D_POSIX_C_SOURCE=200809L)
$(call compile,$(1),$(2),tests/stability,$(STABILITY_FLAGS))
$(call archive,$(call library,$(1),$(2)),$(call objects,$(1),$(2),$(SOURCES)),src/sources.list)
$(call archive,$(BUILD)/make/$(1)/libhost-$(2).a,$(call objects,$(1),$(2),$(HOST_HELP)),tests/host)
$(call archive,$(BUILD)/make/$(1)/libstability-$(2).a,$(call objects,$(1),$(2),$(STABILITY_HELP)),tests/stability)

$(BUILD)/make/$(1)/unit/%-$(2): $(BUILD)/make/$(1)/$(2)/tests/unit/%.o $(BUILD)/make/$(1)/unity.o $(call library,$(1),$(2))
	@mkdir -p $$(@D)
	$$(call say,LINK,$$@)
	$$(Q)$$(CC) $$(VARIANT_$(1)) $$(LDFLAGS) $$^ -lm -o $$@

$(BUILD)/make/$(1)/host/%-$(2): $(BUILD)/make/$(1)/$(2)/tests/host/%.o $(BUILD)/make/$(1)/libhost-$(2).a \
        $(BUILD)/make/$(1)/libhost-cxx.a $(call library,$(1),$(2))
	@mkdir -p $$(@D)
	$$(call say,LINK,$$@)
	$$(Q)$$(CXX) $$(VARIANT_$(1)) $$(LDFLAGS) $$^ $$(HOST_LIBRARIES) -o $$@

$(BUILD)/make/$(1)/stability/%-$(2): $(BUILD)/make/$(1)/$(2)/tests/stability/%.o $(BUILD)/make/$(1)/libstability-$(2).a \
        $(BUILD)/make/$(1)/libstability-cxx.a $(BUILD)/make/$(1)/libhost-$(2).a $(BUILD)/make/$(1)/libhost-cxx.a $(call library,$(1),$(2))
	@mkdir -p $$(@D)
	$$(call say,LINK,$$@)
	$$(Q)$$(CXX) $$(VARIANT_$(1)) $$(LDFLAGS) $$^ $$(HOST_LIBRARIES) -o $$@

unit-$(1): $(patsubst %,$(BUILD)/make/$(1)/unit/%-$(2),$(UNIT_TESTS))
host-$(1): $(patsubst %,$(BUILD)/make/$(1)/host/%-$(2),$(HOST_TESTS))
stability-$(1): $(patsubst %,$(BUILD)/make/$(1)/stability/%-$(2),$(STABILITY_TESTS))
endef

HOST_LIBRARIES := -lcmocka -lbox2d -lquadmath -lm

# $(call build_once,variant): what is not compiled for one scalar, and programs of both
define build_once
$(call compile,$(1),once,ports,$(DEMO))
$(call compile,$(1),once,tests/host,$(HOST_FLAGS))
$(call compile,$(1),once,tests/bench,$(HOST_FLAGS))
$(call archive,$(BUILD)/make/$(1)/libhost-cxx.a,$(call objects,$(1),once,$(HOST_CXX)),tests/host)
$(call archive,$(BUILD)/make/$(1)/libstability-cxx.a,$(call objects,$(1),once,$(STABILITY_CXX)),tests/stability)

$(call compile_cxx,$(1),tests/host)
$(call compile_cxx,$(1),tests/stability)
$(call compile_cxx,$(1),tests/bench)

$(BUILD)/make/$(1)/unity.o: $(UNITY_DIR)/src/unity.c $(BUILD)/make/flags
	@mkdir -p $$(@D)
	$$(call say,CC,$$@)
	$$(Q)$$(CC) $$(VARIANT_$(1)) -MMD -MP $(UNITY_CONFIG) -c $$< -o $$@

$(BUILD)/make/$(1)/host/%: $(BUILD)/make/$(1)/once/tests/host/%.o $(SCALARS:%=$(BUILD)/make/$(1)/libhost-%.a) \
        $(BUILD)/make/$(1)/libhost-cxx.a $(foreach s,$(SCALARS),$(call library,$(1),$(s)))
	@mkdir -p $$(@D)
	$$(call say,LINK,$$@)
	$$(Q)$$(CXX) $$(VARIANT_$(1)) $$(LDFLAGS) $$^ $$(HOST_LIBRARIES) -o $$@

host-$(1): $(patsubst %,$(BUILD)/make/$(1)/host/%,$(HOST_ONCE))
.PHONY: unit-$(1) host-$(1) stability-$(1)
endef

$(foreach v,plain sanitized,$(eval $(call build_once,$(v)))$(foreach s,$(SCALARS),$(eval $(call build,$(v),$(s)))))

DEMO_OBJECTS := $(call objects,plain,once,$(DEMO_ONCE)) $(foreach s,$(SCALARS),$(call objects,plain,$(s),$(DEMO_BOTH)))
$(BUILD)/tuff-demo: $(DEMO_OBJECTS) $(LIBRARIES) ports/desktop/demo.list
	$(call say,LINK,$@)
	$(Q)$(CC) $(CFLAGS) $(LDFLAGS) $(DEMO_OBJECTS) $(LIBRARIES) -lm -o $@

# The rocks' headers are committed, so that a C compiler is enough. Where tools/shapes is there, a changed picture is traced anew.
ROCKS        := ports/scene/rocks
ROCK_HEADERS := $(patsubst %.png,%.h,$(wildcard $(ROCKS)/*.png))
ROCK_OPTIONS  = --quiet --name $*_rocks $(if $(filter concave,$*),--strip 3,--strip 5 --model hull)

$(SCALARS:%=$(BUILD)/make/plain/%/ports/scene/shapes.o): $(ROCK_HEADERS)
ifneq ($(wildcard $(SHAPE_TOOLS)/ready),)
$(ROCKS)/%.h: $(ROCKS)/%.png
	$(call say,ROCK,$@)
	$(Q)$(SHAPES) $(ROCK_OPTIONS) $< -o $@
endif

# $(call bench_objects,program): what tests/bench/bench.list names for bench, gate or models
bench_names   = $(patsubst %,tests/bench/%,$(call lines,tests/bench/bench.list,-n -e 's/^$(1) $(2) //p'))
bench_objects = $(call objects,plain,once,$(call bench_names,$(1),once)) $(call objects,plain,q16,$(call bench_names,$(1),fixed)) \
    $(foreach s,$(SCALARS),$(call objects,plain,$(s),$(call bench_names,$(1),each)))
BENCH_OBJECTS   := $(call bench_objects,bench)
GATE_OBJECTS    := $(call bench_objects,gate)
MODEL_OBJECTS   := $(call bench_objects,models)
SET_OBJECTS     := $(call bench_objects,sets)
BENCH_LIBRARIES := $(LIBRARIES) $(BUILD)/make/plain/libhost-q16.a $(BUILD)/make/plain/libhost-cxx.a

$(BUILD)/tuff-bench: $(BENCH_OBJECTS) $(BENCH_LIBRARIES) tests/bench/bench.list
	$(call say,LINK,$@)
	$(Q)$(CXX) $(CFLAGS) $(LDFLAGS) $(BENCH_OBJECTS) $(BENCH_LIBRARIES) -lbox2d -lchipmunk -lquadmath -lm -o $@

$(BUILD)/tuff-gate: $(GATE_OBJECTS) $(BENCH_LIBRARIES) tests/bench/bench.list
	$(call say,LINK,$@)
	$(Q)$(CC) $(CFLAGS) $(LDFLAGS) $(GATE_OBJECTS) $(BENCH_LIBRARIES) -lquadmath -lm -o $@

$(BUILD)/bench-sets: $(SET_OBJECTS) $(BENCH_LIBRARIES) tests/bench/bench.list
	$(call say,LINK,$@)
	$(Q)$(CC) $(CFLAGS) $(LDFLAGS) $(SET_OBJECTS) $(BENCH_LIBRARIES) -lquadmath -lm -o $@

$(BUILD)/count.so: ports/qemu/count.c
	@mkdir -p $(@D)
	$(call say,LINK,$@)
	$(Q)$(CC) -std=c99 -O2 $(WARNINGS) $(WERROR) -fPIC -shared $< -o $@

$(BUILD)/bench-models: $(MODEL_OBJECTS) $(LIBRARIES) tests/bench/bench.list
	$(call say,LINK,$@)
	$(Q)$(CC) $(CFLAGS) $(LDFLAGS) $(MODEL_OBJECTS) $(LIBRARIES) -lm -o $@

$(UNITY_DIR)/src/unity.c:
	scripts/get-unity '$(UNITY_DIR)'

$(BUILD)/picture-tools/ready: ports/desktop/requirements.txt
	$(PYTHON) -m venv $(BUILD)/picture-tools
	$(BUILD)/picture-tools/bin/python -m pip install --quiet --requirement ports/desktop/requirements.txt
	@touch $@

$(SHAPE_TOOLS)/ready: tools/shapes/requirements.txt tests/shapes/requirements.txt
	PYTHON='$(PYTHON)' scripts/get-shape-tools $(SHAPE_TOOLS) $^
	@touch $@

-include $(shell test -d $(BUILD)/make && find $(BUILD)/make -name '*.d')
