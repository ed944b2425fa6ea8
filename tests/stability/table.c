/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Cells of the table, one a line: family number; family; measure; column; method; figure. */
#include "table.h"

#include <stdarg.h>
#include <stdio.h>

#include "exact.h"

static int family_number;
static const char *family_name = "", *row_measure = "";

void table_family(int number, const char *name)
{
    family_number = number;
    family_name = name;
}

void table_row(const char *measure)
{
    row_measure = measure;
}

static void print_cell(const char *column, const char *method, const char *figure, va_list values)
{
    printf("cell: %d;%s;%s;%s;%s;", family_number, family_name, row_measure, column, method);
    vprintf(figure, values);
    printf("\n");
}

void table_fails(const char *method, const char *figure, ...)
{
    va_list values;
    va_start(values, figure);
    print_cell("fails-" EXACT_BUILD, method, figure, values);
    va_end(values);
}

void table_box2d(const char *figure, ...)
{
    va_list values;
    va_start(values, figure);
    print_cell("box2d-" EXACT_BUILD, "", figure, values);
    va_end(values);
}

void table_tuff(const char *figure, ...)
{
    va_list values;
    va_start(values, figure);
    print_cell(EXACT_BUILD, "", figure, values);
    va_end(values);
}
