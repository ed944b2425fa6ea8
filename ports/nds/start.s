@ SPDX-License-Identifier: Zlib
@ Copyright (c) 2026 the tuff authors
@
@ Cartridge header and start-up of a Nintendo DS program: stack, memory, main on the ARM9, whose caches and coprocessor stay as they are
@ found; the ARM7 sleeps. The linker script gives both CPUs' code a fixed size, so that the header is the same in every program and its two
@ checksums are constants, which ports/nds/run.c compares. The logo is zero: loaders of homebrew do not read it.

    .syntax unified
    .arch armv5te

    .section .header, "a", %progbits
    .ascii  "TUFF"                  @ title, 12 bytes
    .space  8
    .ascii  "####00"                @ code of the game: homebrew; of its maker
    .byte   0, 0, 2                 @ unit: Nintendo DS; seed; capacity: 128 KB << 2
    .space  11
    .word   arm9_place              @ 0x20: ARM9: where in the file, entry, where in memory, size
    .word   start
    .word   arm9_start
    .word   arm9_size
    .word   arm7_place              @ 0x30: ARM7: the same
    .word   arm7_sleep
    .word   arm7_sleep
    .word   arm7_size
    .space  0x40
    .word   file_size               @ 0x80: size of the file
    .word   arm9_place              @ size of the header
    .space  0x38
    .space  156                     @ 0xC0: logo
    .hword  0xE155                  @ 0x15C: checksum of the logo
    .hword  0xF360                  @ 0x15E: checksum of all before
    .space  0xA0

    .section .arm7, "ax", %progbits
    .arm
    .global arm7_sleep
arm7_sleep:
    mov     r0, #0x04000000
    mov     r1, #0x80               @ HALTCNT: until an interrupt, and none is enabled
    strb    r1, [r0, #0x301]
    b       arm7_sleep

    .section .start, "ax", %progbits
    .arm
    .global start
start:
    mov     r0, #0x04000000         @ IME: no interrupts
    str     r0, [r0, #0x208]
    ldr     sp, =stack_top
    ldr     r1, =bss_start
    ldr     r2, =bss_end
    mov     r3, #0
1:  cmp     r1, r2
    strlo   r3, [r1], #4
    blo     1b

    mov     r0, #0
    mov     r1, #0
    ldr     r3, =main
    blx     r3
    ldr     r3, =exit               @ r0: what main returned
    bx      r3

    .pool
