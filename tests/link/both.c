/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   A program that holds both builds: each must give half a unit. */
#include <stdint.h>

int32_t tuff_float_side_push_in_q16_16(void);
int32_t tuff_q16_side_push_in_q16_16(void);

int main(void)
{
    return tuff_float_side_push_in_q16_16() == 32768 && tuff_q16_side_push_in_q16_16() == 32768 ? 0 : 1;
}
