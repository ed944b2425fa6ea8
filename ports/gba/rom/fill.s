@ SPDX-License-Identifier: Zlib
@ Copyright (c) 2026 the tuff authors
@
@ What writes most of the picture: one stm writes eight words in 17 cycles; the eight stores that a compiler makes take 24.

    .syntax unified
    .arch armv4t
    .cpu arm7tdmi

    .equ    width, 240
    .equ    to_right, 2 * 124       @ from a row's left end to its right one: PAINT_HEIGHT numbers, which paint.c compares

    .macro  spread ink
    mov     r4, \ink
    mov     r5, \ink
    mov     r6, \ink
    mov     r7, \ink
    mov     r8, \ink
    mov     r9, \ink
    mov     r10, \ink
    mov     r11, \ink
    .endm

@ void paint_fill(uint16_t *row, int twos, uint32_t ink): whole rows, two a turn, which are 15 times eight words.
    .section .iwram.paint_fill, "ax", %progbits
    .arm
    .global paint_fill
paint_fill:
    push    {r4-r11}
    spread  r2
1:
    .rept   15
    stm     r0!, {r4-r11}
    .endr
    subs    r1, r1, #1
    bgt     1b
    pop     {r4-r11}
    bx      lr

@ void paint_rows(uint16_t *row, const int16_t *ends, int rows, uint32_t ink): each row from the lesser of its two ends to the one before
@ the greater, cut at the page's sides. An odd pixel at an end is half of a pair, whose other half stays; the rest goes by pairs to a whole
@ word, then by words.
    .section .iwram.paint_rows, "ax", %progbits
    .arm
    .global paint_rows
paint_rows:
    push    {r4-r11, lr}
    spread  r3
1:  ldrsh   r12, [r1, #to_right]
    ldrsh   r3, [r1], #2
    cmp     r3, r12
    movgt   lr, r3
    movgt   r3, r12
    movgt   r12, lr
    bic     r3, r3, r3, asr #31
    cmp     r12, #width
    movgt   r12, #width
    cmp     r3, r12
    bge     4f
    add     r12, r0, r12
    add     r3, r0, r3
    tst     r3, #1
    ldrbne  lr, [r3, #-1]!
    andne   r4, r4, #0xFF00
    orrne   lr, lr, r4
    strhne  lr, [r3], #2
    movne   r4, r5
    tst     r12, #1
    ldrbne  lr, [r12]
    andne   r4, r4, #0xFF
    orrne   lr, r4, lr, lsl #8
    strhne  lr, [r12, #-1]!
    movne   r4, r5
    cmp     r3, r12
    bhs     4f
    tst     r3, #2
    strhne  r4, [r3], #2
    tst     r12, #2
    strhne  r4, [r12, #-2]!
    sub     lr, r12, r3
    subs    lr, lr, #32
    blo     3f
2:  stm     r3!, {r4-r11}
    subs    lr, lr, #32
    bhs     2b
3:  movs    r12, lr, lsl #28        @ what is left: carry 16 bytes, minus 8
    stmcs   r3!, {r4-r7}
    stmmi   r3!, {r4-r5}
    tst     lr, #4
    strne   r4, [r3]
4:  add     r0, r0, #width
    subs    r2, r2, #1
    bgt     1b
    pop     {r4-r11, lr}
    bx      lr

@ void paint_steep(uint16_t *row, int32_t x, int32_t slope, int rows, uint32_t ink): a pixel a row, at x + n slope in steps of 2^-16 of a
@ pixel; none may lie outside of the page. Half of a pair each; its other half stays. A vertical line has loops of its own.
    .section .iwram.paint_steep, "ax", %progbits
    .arm
    .global paint_steep
paint_steep:
    push    {r4-r5, lr}
    ldr     r4, [sp, #12]
    and     r5, r4, #0xFF00
    and     r4, r4, #0xFF
    cmp     r2, #0
    beq     2f
1:  add     r12, r0, r1, asr #16
    tst     r12, #1
    ldrbne  lr, [r12, #-1]!
    orrne   lr, lr, r5
    ldrbeq  lr, [r12, #1]
    orreq   lr, r4, lr, lsl #8
    strh    lr, [r12]
    add     r0, r0, #width
    add     r1, r1, r2
    subs    r3, r3, #1
    bgt     1b
    pop     {r4-r5, lr}
    bx      lr

2:  add     r0, r0, r1, asr #16
    tst     r0, #1
    beq     4f
    sub     r0, r0, #1
3:  ldrb    lr, [r0]
    orr     lr, lr, r5
    strh    lr, [r0], #width
    subs    r3, r3, #1
    bgt     3b
    pop     {r4-r5, lr}
    bx      lr
4:  ldrb    lr, [r0, #1]
    orr     lr, r4, lr, lsl #8
    strh    lr, [r0], #width
    subs    r3, r3, #1
    bgt     4b
    pop     {r4-r5, lr}
    bx      lr
