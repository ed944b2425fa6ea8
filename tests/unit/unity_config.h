/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   What the unit tests ask of Unity: integers only, so that it fits the small machines. Given to the compiler by
   -include, for Unity's own source too; the guard has the name of Unity's example file, which some copies read after this one. */
#ifndef UNITY_CONFIG_H
#define UNITY_CONFIG_H

#define UNITY_EXCLUDE_FLOAT
#define UNITY_EXCLUDE_DOUBLE
#define UNITY_EXCLUDE_MATH_H

/* Where string literals take RAM (AVR), the names of the tests do not fit: the line number tells which it was. */
#ifdef TEST_NAMES_OFF
#define TEST_NAME(text) ""
#else
#define TEST_NAME(text) text
#endif

/* Where flash is small, a file of tests makes TEST_SLICES programs, and each runs its share. */
#ifndef TEST_SLICES
#define TEST_SLICES 1
#define TEST_SLICE  0
#endif
#define RUN_TEST(test) \
    do { \
        if (__LINE__ % TEST_SLICES == TEST_SLICE) UnityDefaultTestRun(test, TEST_NAME(#test), __LINE__); \
    } while (0)

#endif
