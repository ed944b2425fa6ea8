@ SPDX-License-Identifier: Zlib
@ Copyright (c) 2026 the tuff authors
@
@ Between the scene and tuff, without a change to either: the linker's --wrap leads each call of a function named below here. The
@ outermost call's cycles are added to meter_cycles; what the library calls in itself goes through. Parameters, on the stack too, and
@ result stay where they are. rom.mk takes the names from this file.

    .syntax unified
    .arch armv4t
    .cpu arm7tdmi

    .macro metered name
    .global __wrap_tuff_q16_\name
__wrap_tuff_q16_\name:
    ldr     ip, =__real_tuff_q16_\name
    b       measure
    .endm

    .section .iwram, "awx", %progbits
    .arm
    metered terrain_collide_report
    metered floater_collide_report
    metered floater_collide_circle
    metered segment_terrain_intersect
    metered segment_terrain_first_hit
    metered segment_circle
    metered circle_circle
    metered bounce
    metered nearby_terrain
    metered chunks_insert
    metered chunks_remove

@ ip: the function. Timer 0 counts cycles, but only to 65,536, which a body that is pushed 16 times takes; timer 2 counts each 1024th and
@ tells how often timer 0 has begun anew.
measure:
    str     r4, kept
    ldr     r4, return
    cmp     r4, #0
    ldrne   r4, kept
    bxne    ip
    str     lr, return
    ldr     r4, =0x04000100
    ldrh    lr, [r4, #8]
    ldrh    r4, [r4]
    str     lr, begun_coarse
    str     r4, begun
    ldr     r4, kept
    mov     lr, pc
    bx      ip

    ldr     ip, =0x04000100
    ldrh    r3, [ip, #8]
    ldrh    r2, [ip]
    ldr     ip, begun
    sub     r2, r2, ip
    lsl     r2, r2, #16
    lsr     r2, r2, #16
    ldr     ip, begun_coarse
    sub     r3, r3, ip
    lsl     r3, r3, #16
    rsb     r3, r2, r3, lsr #6
    add     r3, r3, #32768          @ to the nearest
    lsr     r3, r3, #16
    add     r2, r2, r3, lsl #16
    ldr     r3, meter_cycles
    add     r3, r3, r2
    str     r3, meter_cycles
    ldr     lr, return
    mov     r2, #0
    str     r2, return
    bx      lr

    .global meter_cycles
meter_cycles: .word 0
return: .word 0
begun:  .word 0
begun_coarse: .word 0
kept:   .word 0
    .pool
