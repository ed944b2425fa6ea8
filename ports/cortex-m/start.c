/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Start-up of a Cortex-M under an emulator: vectors, data, floating-point unit, then main, whose result ends the emulator. Text and exit
   code go through semihosting (newlib's rdimon). A fault ends it too, with a code of its own, instead of a hang. */
#include <stdint.h>
#include <stdlib.h>

#define FAULT_CODE 99u

extern uint32_t stack_top, data_load, data_start, data_end, bss_start, bss_end;
extern void initialise_monitor_handles(void);
extern int main(void);

void start(void);

/* Semihosting's SYS_EXIT_EXTENDED with ADP_Stopped_ApplicationExit. */
static void fault(void)
{
    static const uint32_t reason[2] = { 0x20026u, FAULT_CODE };
    register uint32_t operation __asm__("r0") = 0x20;
    register const uint32_t *argument __asm__("r1") = reason;
    __asm__ volatile("bkpt 0xAB" : : "r"(operation), "r"(argument) : "memory");
    for (;;) {}
}

typedef void (*handler)(void);

/* The stack's top, reset, then the faults; interrupts are never enabled. */
static const struct vectors {
    uint32_t *stack;
    handler   handlers[15];
} vectors __attribute__((section(".vectors"), used)) = {
    &stack_top, { start, fault, fault, fault, fault, fault, NULL, NULL, NULL, NULL, fault, fault, NULL, fault, fault }
};

void start(void)
{
    uint32_t *from = &data_load;
    uint32_t *to;
    for (to = &data_start; to < &data_end; ++to) *to = *from++;
    for (to = &bss_start; to < &bss_end; ++to) *to = 0;
#if defined(__ARM_FP)
    *(volatile uint32_t *)0xE000ED88 |= 0xFu << 20;    /* CPACR: full access to the floating-point unit */
    __asm__ volatile("dsb\n isb");
#endif
    initialise_monitor_handles();
    exit(main());
}

/* newlib calls them around main's life; there is nothing to do. */
void _init(void) {}
void _fini(void) {}
