@ SPDX-License-Identifier: Zlib
@ Copyright (c) 2026 the tuff authors
@
@ Cartridge header and start-up of a Game Boy Advance program: stacks, memory, main. The 156 bytes of the logo are zero: emulators with a
@ BIOS of their own start it; for a real console put the logo in with a tool such as gbafix. The byte at 0xBD is the header's checksum:
@ 0x00 - 0x19 - the sum of 0xA0 .. 0xBC, which scripts/check-gba-header compares.

    .syntax unified
    .arch armv4t
    .cpu arm7tdmi

    .section .header, "ax", %progbits
    .arm
    .global start
start:
    b       reset
    .space  156
    .ascii  "TUFF"                  @ 0xA0: title, 12 bytes
    .space  8
    .ascii  "ZTFE00"                @ 0xAC: code of the game, of its maker
    .byte   0x96                    @ 0xB2: fixed
    .space  10
    .byte   0x83                    @ 0xBD: checksum
    .space  2

reset:
    mov     r0, #0x12               @ interrupts' mode, its stack
    msr     cpsr_c, r0
    ldr     sp, =stack_interrupt
    mov     r0, #0x1F               @ system mode, main's stack
    msr     cpsr_c, r0
    ldr     sp, =stack_top
    ldr     r0, =0x04000208         @ no interrupts
    mov     r1, #0
    str     r1, [r0]
    ldr     r0, =0x04000204         @ WAITCNT: ROM at 3 and 1 wait states, with prefetch
    ldr     r1, =0x4317
    strh    r1, [r0]

    ldr     r0, =iwram_load
    ldr     r1, =iwram_start
    ldr     r2, =iwram_end
    bl      copy
    ldr     r0, =data_load
    ldr     r1, =data_start
    ldr     r2, =data_end
    bl      copy
    ldr     r1, =bss_start
    ldr     r2, =bss_end
    bl      clear
    ldr     r1, =ewram_start
    ldr     r2, =ewram_end
    bl      clear

    mov     r0, #0
    mov     r1, #0
    ldr     r3, =main
    mov     lr, pc
    bx      r3
    ldr     r3, =exit               @ r0: what main returned
    bx      r3

copy:
    cmp     r1, r2
    ldrlo   r3, [r0], #4
    strlo   r3, [r1], #4
    blo     copy
    bx      lr

clear:
    mov     r3, #0
1:  cmp     r1, r2
    strlo   r3, [r1], #4
    blo     1b
    bx      lr

    .pool
