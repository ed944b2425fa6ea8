/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The config header of an SDK that has the standard types itself, in its own way: no <stdint.h>, no <stdbool.h>. Unlike the standard's,
   its bool is a plain byte. */
#ifndef OWN_TYPES_H
#define OWN_TYPES_H

#define TUFF_NO_STD_TYPES

typedef signed char        int8_t;
typedef unsigned char      uint8_t;
typedef short              int16_t;
typedef unsigned short     uint16_t;
typedef int                int32_t;
typedef unsigned int       uint32_t;
__extension__ typedef long long          int64_t;
__extension__ typedef unsigned long long uint64_t;

#ifndef __cplusplus
typedef unsigned char bool;
#define true  1
#define false 0
#endif

#endif
