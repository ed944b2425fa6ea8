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
#define RUN_TEST(test) UnityDefaultTestRun(test, "", __LINE__)
#endif

#endif
