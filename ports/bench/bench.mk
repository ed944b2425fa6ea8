# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# Builds the programs that count cycles or instructions for one machine; run by scripts/run-cycles:
#   make -f ports/bench/bench.mk MACHINE=gba HOT=1 OUT=build/cycles/gba-iwram-arm SETS=build/cycles/host/bench-sets count
# HOT: the method's code as ARM code in IWRAM, by the linker script's rule for libhot.a. BOX2D: the folder of Box2D's sources; empty:
# without it.
# What the machines differ in:
#   BENCH_COUNTER   how it is counted: gba, qemu or avr (ports/bench/count.h)
#   BENCH_PAIRS     pairs of each class, and the polygons' numbers of vertices
#   BENCH_SIZES     -DBENCH_MAX_VERTICES=N, the most of a polygon, if not 16
#   BENCH_SCENE     empty where there is too little RAM for the reference scene

ifneq ($(HOT),)
OPTIMIZE := -O2 -marm
endif
include ports/target.mk

BENCH_COUNTER ?= qemu
BENCH_PAIRS   ?= 64 8 16
BENCH_SCENE   ?= scene
BENCH_FLAGS   := -Iports/bench -I$(OUT)/bench -Itests/bench -DBENCH_COUNTER='"count_$(BENCH_COUNTER).h"' $(BENCH_SIZES)
BENCH_METHODS ?= tuff textbook
# Box2D counts in float; two kinds of machine show what that means without a floating-point unit and with one.
BENCH_BOX2D   := $(and $(filter gba cortex-m4f cortex-m7f,$(MACHINE)),$(filter float,$(BUILDS)),$(BOX2D))

BENCH_PROGRAMS := $(BENCH_METHODS:%=pairs-%) bounce-tuff $(BENCH_SCENE:%=%-tuff)
# The float build's code of the scene, with libgcc's floating point, is too much for IWRAM by 5 KB.
BENCH_LEFT_OUT := $(if $(HOT),scene-tuff-float)
BENCH_ALL      := $(filter-out $(BENCH_LEFT_OUT),$(foreach b,$(BUILDS),$(BENCH_PROGRAMS:%=%-$(b)))) $(if $(BENCH_BOX2D),pairs-box2d-float)
BENCH_FILES    := $(BENCH_ALL:%=$(OUT)/bench/%$(IMAGE))
BENCH_MARKS    := $(patsubst ports/%.c,$(OUT)/%.o,$(wildcard ports/bench/count_$(BENCH_COUNTER).c))

# 32 KB of IWRAM hold the scene and all that it calls; what no counted call reaches stays in ROM.
BENCH_COLD    := check chunks fault_text seams substeps world_index
BENCH_ARCHIVE := $(if $(HOT),libhot.a,libbench.a)
BENCH_LIBRARY  = $(if $(HOT),$(filter-out $(BENCH_COLD:%=$(OUT)/$(1)/%.o),$(call objects,$(1),$(SOURCES))))

count: $(BENCH_FILES) $(RUNNER:%=$(OUT)/%)

# For the script; programs as lines `PROGRAM METHOD BUILD`.
programs: ; @for p in $(BENCH_ALL); do echo "$$p" | tr '-' ' '; done
counter:  ; @echo $(BENCH_COUNTER)
.PHONY: count programs counter

$(OUT)/bench/pairs_data.h: $(SETS)
	@mkdir -p $(@D)
	@$(SETS) pairs $(BENCH_PAIRS) > $@

$(OUT)/bench/scene_data.h: $(SETS)
	@mkdir -p $(@D)
	@$(SETS) scene > $@

# The tables, and what else knows no scalar.
$(OUT)/bench/sets_%.o: ports/bench/sets_%.c $(OUT)/bench/%_data.h
	@$(TARGET_CC) $(FLAGS) $(BENCH_FLAGS) -c $< -o $@

$(OUT)/bench/count_%.o: ports/bench/count_%.c
	@mkdir -p $(@D)
	@$(TARGET_CC) $(FLAGS) -c $< -o $@

# $(call bench_folder,build,folder): its files compiled for the build
define bench_folder
$(OUT)/bench/$(1)/%.o: $(2)/%.c
	@mkdir -p $$(@D)
	@$(TARGET_CC) $(FLAGS) $(SCALAR_$(1)) $(BENCH_FLAGS) -c $$< -o $$@
endef

# $(call bench_archive,program and method,build,objects), then the program
define bench_program
$(OUT)/bench/$(2)/$(1)/$(BENCH_ARCHIVE): $(3) ports/bench/bench.mk
	@mkdir -p $$(@D)
	@rm -f $$@ && ar rcs $$@ $(3)

$(OUT)/bench/$(1)-$(2): $(OUT)/bench/$(2)/$(firstword $(subst -, ,$(1))).o $(OUT)/bench/sets_$(if $(filter scene%,$(1)),scene,pairs).o \
        $(BENCH_MARKS) $(START:%=$(OUT)/%.o) $(OUT)/bench/$(2)/$(1)/$(BENCH_ARCHIVE) $(OUT)/$(2)/libtuff.a
	@$(TARGET_CC) $(TARGET_FLAGS) $$^ $(TARGET_LINK) -Wl,--gc-sections -lm -o $$@
endef

define bench_build
$(call bench_folder,$(1),ports/bench)
$(call bench_folder,$(1),tests/bench)
$(call bench_program,pairs-tuff,$(1),$(OUT)/bench/$(1)/method_tuff.o $(BENCH_LIBRARY))
$(call bench_program,pairs-textbook,$(1),$(addprefix $(OUT)/bench/$(1)/,method_textbook.o textbook.o) $(BENCH_LIBRARY))
$(call bench_program,bounce-tuff,$(1),$(OUT)/bench/$(1)/calls.o $(BENCH_LIBRARY))
$(call bench_program,scene-tuff,$(1),$(OUT)/bench/$(1)/calls.o $(BENCH_LIBRARY))
endef
$(foreach b,$(BUILDS),$(eval $(call bench_build,$(b))))

# ---- Box2D: its narrow phase alone

BOX2D_SOURCES := $(addprefix src/collision/b2_,collide_circle collide_polygon collision distance circle_shape polygon_shape) \
    $(addprefix src/common/,b2_math b2_settings b2_block_allocator)
BOX2D_OBJECTS := $(BOX2D_SOURCES:src/%=$(OUT)/bench/box2d/%.o)
BOX2D_FLAGS    = $(TARGET_FLAGS) $(OPTIMIZE) -std=gnu++11 -fno-exceptions -fno-rtti -fno-threadsafe-statics -ffp-contract=off \
    -ffunction-sections -fdata-sections -DNDEBUG -isystem ports/bench/cxx -isystem $(BOX2D)/include
TARGET_CXX     = $(TARGET_CC:%gcc=%g++)

$(OUT)/bench/box2d/%.o: $(BOX2D)/src/%.cpp
	@mkdir -p $(@D)
	@$(TARGET_CXX) $(BOX2D_FLAGS) -c $< -o $@

$(OUT)/bench/box2d/%.o: ports/bench/%.cpp
	@mkdir -p $(@D)
	@$(TARGET_CXX) $(BOX2D_FLAGS) $(BENCH_FLAGS) -c $< -o $@

$(eval $(call bench_program,pairs-box2d,float,$(addprefix $(OUT)/bench/box2d/,method_box2d.o cxx/library.o) $(BOX2D_OBJECTS)))

-include $(shell test -d $(OUT)/bench && find $(OUT)/bench -name '*.d')
