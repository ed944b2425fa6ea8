# SPDX-License-Identifier: Zlib
# Copyright (c) 2026 the tuff authors
#
# The demo as a Game Boy Advance ROM, run by `make rom`: make -f ports/gba/rom/rom.mk OUT=build/rom. The tools are those of
# ports/machines/gba.mk; what is hot is ARM code in IWRAM: what the library marks TUFF_HOT, and the sources in HOT, file-local functions
# included.

include ports/machines/gba.mk

OUT ?= build/rom
ROM ?= build/tuff.gba

lines = $(shell sed -e 's/\#.*//' $(2) $(1))
SOURCES := $(call lines,src/sources.list) $(filter ports/scene/%,$(call lines,ports/desktop/demo.list,-n -e 's/^both //p' -e 's/^once //p')) \
           $(wildcard ports/gba/rom/*.c)
COLD_LIBRARY := beam_hit chunks world_index edge_normals check fault_text nearby segment_circle substeps seams
HOT := $(filter-out $(COLD_LIBRARY:%=src/%.c),$(filter src/%,$(SOURCES))) ports/scene/math.c ports/scene/draw.c ports/gba/rom/paint.c

WARNINGS := -Wall -Wextra -Wconversion -Wsign-conversion -Wdouble-promotion -Wshadow -pedantic -Werror
BELT     := -DSCENE_ENEMIES=5 -DSCENE_FLOATERS=4 -DSCENE_SHOTS=8 -DSCENE_TRIES=3
FLAGS    := $(TARGET_FLAGS) -std=c99 -ffunction-sections -fdata-sections $(WARNINGS) -MMD -MP -DTUFF_SCALAR=TUFF_Q16_16 \
            -DTUFF_CONFIG_HEADER='"tuff_gba.h"' -Iinclude -Isrc -Iports/scene -Iports/gba/rom $(BELT)
# What loops most at -O2; for the rest the room is better spent on the stack.
HOT_FLAGS  := -Os -marm
# Functions of hot sources that only beams of unusual length, or past a circle, come to: they stay in ROM.
RARE       := tuff_q16_far_dot tuff_q16_far_cross tuff_q16_far_direction tuff_far_reduce tuff_add_product tuff_q16_circle_entry \
              tuff_q16_ratio tuff_q16_ratio_less tuff_q16_chord_reaches
COLD_FLAGS := -O2
$(addprefix $(OUT)/hot/,ports/gba/rom/paint.o ports/scene/draw.o ports/scene/math.o src/circle_polygon.o src/walk.o): HOT_FLAGS := -O2 -marm
METERED  := $(shell sed -n 's/^ *metered //p' ports/gba/rom/meter.s)

HOT_OBJECTS  := $(HOT:%.c=$(OUT)/hot/%.o)
COLD_OBJECTS := $(patsubst %.c,$(OUT)/cold/%.o,$(filter-out $(HOT),$(SOURCES)))
STARTING     := $(OUT)/start.o $(OUT)/console.o $(OUT)/newlib.o $(OUT)/meter.o $(OUT)/fill.o

$(ROM): $(OUT)/tuff.elf
	@arm-none-eabi-objcopy -O binary $< $@

$(OUT)/tuff.elf: $(HOT_OBJECTS) $(COLD_OBJECTS) $(STARTING) ports/gba/gba.ld
	@$(TARGET_CC) $(TARGET_FLAGS) $(filter %.o,$^) $(TARGET_LINK) -Wl,--defsym=exit=_exit $(METERED:%=-Wl,--wrap=tuff_q16_%) \
	    -Wl,--gc-sections -Wl,-Map=$(@:.elf=.map) -o $@

$(OUT)/hot/%.o: %.c ports/gba/rom/rom.mk
	@mkdir -p $(@D)
	@$(TARGET_CC) $(FLAGS) $(HOT_FLAGS) -c $< -o $@
	@arm-none-eabi-objcopy $(foreach name,$(RARE),--rename-section .text.$(name)=.rare.$(name)) $@

$(OUT)/cold/%.o: %.c ports/gba/rom/rom.mk
	@mkdir -p $(@D)
	@$(TARGET_CC) $(FLAGS) $(COLD_FLAGS) -c $< -o $@

$(OUT)/console.o: ports/gba/console.c
$(OUT)/newlib.o: ports/common/newlib.c
$(OUT)/console.o $(OUT)/newlib.o:
	@mkdir -p $(@D)
	@$(TARGET_CC) $(TARGET_FLAGS) -O2 -ffunction-sections -std=gnu99 -c $< -o $@

$(OUT)/start.o: ports/gba/start.s
$(OUT)/meter.o: ports/gba/rom/meter.s
$(OUT)/fill.o: ports/gba/rom/fill.s
$(OUT)/start.o $(OUT)/meter.o $(OUT)/fill.o:
	@mkdir -p $(@D)
	@$(TARGET_CC) $(TARGET_FLAGS) -c $< -o $@

# The emulator's front end, for the host.
$(OUT)/run: ports/gba/run.c
	@mkdir -p $(@D)
	@$(CC) -std=gnu99 -O2 $< $(RUNNER_LINK) -o $@

-include $(shell test -d $(OUT) && find $(OUT) -name '*.d')
