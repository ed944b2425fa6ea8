/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   A text for every fault. DESIGN 2 ("an enum and a text for each fault"). */
#include "support.h"

void setUp(void) {}
void tearDown(void) {}

static bool same_text(const char *a, const char *b)
{
    while (*a != '\0' && *a == *b) {
        a++;
        b++;
    }
    return *a == *b;
}

static void test_each_fault_has_a_text_of_its_own(void)
{
    for (uint8_t i = 0; i <= TUFF_FAULT_COUNT; i++) {
        for (uint8_t j = 0; j < i; j++) TEST_ASSERT_FALSE(same_text(tuff_fault_text((tuff_fault)i), tuff_fault_text((tuff_fault)j)));
    }
}

static void test_texts_are_one_sentence_without_a_period(void)
{
    for (uint8_t i = 0; i < TUFF_FAULT_COUNT; i++) {
        const char *text = tuff_fault_text((tuff_fault)i);
        uint8_t length = 0;
        TEST_ASSERT_NOT_NULL(text);
        while (text[length] != '\0') length++;
        TEST_ASSERT_TRUE(length >= 8 && length < 100);
        TEST_ASSERT_TRUE(text[length - 1] != '.' && text[length - 1] != '\n');
    }
}

static void test_numbers_that_are_no_fault_have_a_text_too(void)
{
    TEST_ASSERT_NOT_NULL(tuff_fault_text(TUFF_FAULT_COUNT));
    TEST_ASSERT_TRUE(same_text(tuff_fault_text(TUFF_FAULT_COUNT), tuff_fault_text((tuff_fault)(TUFF_FAULT_COUNT + 1))));
    TEST_ASSERT_NOT_NULL(tuff_fault_text((tuff_fault)63));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_each_fault_has_a_text_of_its_own);
    RUN_TEST(test_texts_are_one_sentence_without_a_period);
    RUN_TEST(test_numbers_that_are_no_fault_have_a_text_too);
    return UNITY_END();
}
