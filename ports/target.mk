# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# Builds the unit tests and the replay for one machine, in the builds that it allows; run by scripts/run-target:
#   make -f ports/target.mk MACHINE=mips OUT=build/targets/mips UNITY_DIR=build/unity
# A machine is an overlay of settings, ports/machines/MACHINE.mk:
#   NAME         what it is, and stands for
#   PACKAGES     Debian's packages that it needs
#   FETCH        the command that gets what it needs and no package installs; none for most
#   TARGET_CC    the compiler        TARGET_FLAGS  for compiling and linking        TARGET_LINK  for linking only
#   START        its start-up code, C or assembler; none where there is an operating system
#   IMAGE        the ending of what is run: nothing for the linked program; .gba or such is made from it by MAKE_IMAGE
#   RUN          the command before the program's name; RUNNER, RUNNER_LINK: its source below ports, where it is ours
#   BUILDS       q16 float, or q16 only where float arithmetic is not IEEE's
#   REPLAY       replay, or replay_small where there is too little RAM for it, or both
#   SLICES       0 1 2 ...: each file of tests makes so many programs, where all of it is too much for one

include ports/machines/$(MACHINE).mk

OPTIMIZE ?= -O2
IMAGE    ?=
REPLAY   ?= replay
BUILDS   ?= q16 float
SLICES   ?= 0

lines   = $(shell sed -e 's/\#.*//' $(2) $(1))
SOURCES := $(call lines,src/sources.list)
TESTS   := $(call lines,tests/unit/tests.list)
SCENE   := $(filter ports/scene/%,$(call lines,ports/desktop/demo.list,-n -e 's/^both //p'))

# What is compiled is compiled anew when they change.
SETTINGS := ports/target.mk ports/machines/$(MACHINE).mk

SCALAR_float := -DTUFF_SCALAR=TUFF_FLOAT
SCALAR_q16   := -DTUFF_SCALAR=TUFF_Q16_16
FLAGS = $(TARGET_FLAGS) $(OPTIMIZE) -std=c99 -ffp-contract=off -ffunction-sections -fdata-sections -MMD -MP -Iinclude
UNIT_FLAGS  = -Isrc -Itests/unit -include tests/unit/unity_config.h -isystem $(UNITY_DIR)/src
SCENE_FLAGS = -Iports/scene

# The names of the programs made of one file of tests.
sliced    = $(if $(word 2,$(SLICES)),$(SLICES:%=$(1).%),$(1))
UNITS    := $(foreach t,$(TESTS),$(call sliced,$(t)))
PROGRAMS := $(foreach b,$(BUILDS),$(patsubst %,$(OUT)/%-$(b)$(IMAGE),$(UNITS:%=unit/%) $(REPLAY:%=replay/%)))

all: $(PROGRAMS) $(RUNNER:%=$(OUT)/%)

# For the scripts.
name:     ; @echo '$(NAME)'
packages: ; @echo $(PACKAGES)
fetch:    ; @$(FETCH)
builds:   ; @echo $(BUILDS)
units:    ; @echo $(UNITS)
replay:   ; @echo $(REPLAY)
image:    ; @echo $(IMAGE)
run:      ; @echo '$(RUN)'
.PHONY: all name packages fetch builds units replay image run
.SECONDARY:
.DELETE_ON_ERROR:

# $(call objects,build,sources)
objects = $(patsubst %,$(OUT)/$(1)/%.o,$(basename $(notdir $(2))))

# $(call compile,build,folder,flags)
define compile
$(OUT)/$(1)/%.o: $(2)/%.c $(SETTINGS)
	@mkdir -p $$(@D)
	@$(TARGET_CC) $(FLAGS) $(SCALAR_$(1)) $(3) -c $$< -o $$@
endef

# $(call compile_slice,build,slice)
define compile_slice
$(OUT)/$(1)/%.$(2).o: tests/unit/%.c $(SETTINGS)
	@mkdir -p $$(@D)
	@$(TARGET_CC) $(FLAGS) $(SCALAR_$(1)) $(UNIT_FLAGS) -DTEST_SLICES=$(words $(SLICES)) -DTEST_SLICE=$(2) -c $$< -o $$@

endef

# $(call link,build)
define link
$(call compile,$(1),src,-Isrc)
$(call compile,$(1),tests/unit,$(UNIT_FLAGS))
$(foreach s,$(SLICES),$(call compile_slice,$(1),$(s)))
$(call compile,$(1),ports/scene,$(SCENE_FLAGS))
$(call compile,$(1),ports/replay,$(SCENE_FLAGS))
$(call compile,$(1),tests/size,)

$(OUT)/unit/%-$(1): $(OUT)/$(1)/%.o $(OUT)/unity.o $(START:%=$(OUT)/%.o) $(call objects,$(1),$(SOURCES))
	@mkdir -p $$(@D)
	@$(TARGET_CC) $(TARGET_FLAGS) $(OPTIMIZE) $$^ $(TARGET_LINK) -Wl,--gc-sections -lm -o $$@

$(OUT)/$(1)/%_trace.o: ports/replay/%.c $(SETTINGS)
	@mkdir -p $$(@D)
	@$(TARGET_CC) $(FLAGS) $(SCALAR_$(1)) $(SCENE_FLAGS) -DREPLAY_TRACE -c $$< -o $$@

$(OUT)/replay/%-$(1): $(OUT)/$(1)/%.o $(START:%=$(OUT)/%.o) $(call objects,$(1),$(SOURCES) $(SCENE))
	@mkdir -p $$(@D)
	@$(TARGET_CC) $(TARGET_FLAGS) $(OPTIMIZE) $$^ $(TARGET_LINK) -Wl,--gc-sections -lm -o $$@

$(OUT)/$(1)/libtuff.a: $(call objects,$(1),$(SOURCES))
	@rm -f $$@ && ar rcs $$@ $$^

# What a feature set of tests/size/sets.c needs of the library, for scripts/print-size: the map tells.
$(OUT)/size/%-$(1): $(OUT)/$(1)/sets.o $(OUT)/$(1)/libtuff.a
	@mkdir -p $$(@D)
	@$(TARGET_CC) $(TARGET_FLAGS) $$^ $(TARGET_LINK) -static -nostartfiles -Wl,--gc-sections,-e,set_$$*,-Map,$$@.map -lm -o $$@
endef
$(foreach b,$(BUILDS),$(eval $(call link,$(b))))

$(OUT)/unity.o: $(UNITY_DIR)/src/unity.c $(SETTINGS)
	@mkdir -p $(@D)
	@$(TARGET_CC) $(FLAGS) $(UNIT_FLAGS) -c $< -o $@

$(OUT)/%.o: ports/%.c $(SETTINGS)
	@mkdir -p $(@D)
	@$(TARGET_CC) $(TARGET_FLAGS) $(OPTIMIZE) -std=gnu99 -c $< -o $@

$(OUT)/%.o: ports/%.s $(SETTINGS)
	@mkdir -p $(@D)
	@$(TARGET_CC) $(TARGET_FLAGS) -c $< -o $@

# The emulator's front end, for the host.
$(RUNNER:%=$(OUT)/%): $(OUT)/%: ports/%.c
	@mkdir -p $(@D)
	@$(CC) -std=gnu99 -O2 $< $(RUNNER_LINK) -o $@

ifneq ($(IMAGE),)
%$(IMAGE): %
	@$(MAKE_IMAGE)
endif

-include $(shell test -d $(OUT) && find $(OUT) -name '*.d')
