/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Runs an ATmega32U4 program in libsimavr: run PROGRAM.elf. Prints what it writes to GPIOR0 and ends with the code in GPIOR2 when it
   writes 0xFF to GPIOR1 (ports/avr/start.c). Other values there measure: n begins, 0 ends and prints `cycles n count`. A crash ends with
   3, 10^11 cycles with 124. */
#include <simavr/sim_avr.h>
#include <simavr/sim_elf.h>
#include <stdio.h>
#include <string.h>

#define TEXT       0x3E     /* data addresses of GPIOR0, 1, 2 */
#define CONTROL    0x4A
#define RESULT     0x4B
#define END        0xFF
#define MOST       100000000000ull
#define CRASHED    3
#define RAN_ON     124
#define RUNNING    (-1)

static int code = RUNNING;
static unsigned measured;
static unsigned long long began;

static void on_text(struct avr_t *avr, avr_io_addr_t address, uint8_t value, void *unused)
{
    (void)unused;
    avr->data[address] = value;
    putchar(value);
}

static void on_control(struct avr_t *avr, avr_io_addr_t address, uint8_t value, void *unused)
{
    (void)unused;
    avr->data[address] = value;
    if (value == END) code = avr->data[RESULT];
    else if (value == 0) printf("cycles %u %llu\n", measured, (unsigned long long)avr->cycle - began);
    else {
        measured = value;
        began = avr->cycle;
    }
}

static avr_t *load(const char *path)
{
    elf_firmware_t firmware;
    memset(&firmware, 0, sizeof firmware);
    avr_t *avr = elf_read_firmware(path, &firmware) == 0 ? avr_make_mcu_by_name("atmega32u4") : NULL;
    if (!avr) return NULL;
    avr_init(avr);
    firmware.frequency = 16000000;
    avr_load_firmware(avr, &firmware);
    avr->log = LOG_ERROR;
    avr_register_io_write(avr, TEXT, on_text, NULL);
    avr_register_io_write(avr, CONTROL, on_control, NULL);
    return avr;
}

int main(int argc, char **argv)
{
    int state = cpu_Running;
    avr_t *avr = argc == 2 ? load(argv[1]) : NULL;
    if (!avr) return fprintf(stderr, "usage: run PROGRAM.elf\n"), 2;
    while (code == RUNNING && state != cpu_Done && state != cpu_Crashed && avr->cycle < MOST) state = avr_run(avr);
    fflush(stdout);
    if (state == cpu_Crashed) return CRASHED;
    return code == RUNNING ? RAN_ON : code;
}
