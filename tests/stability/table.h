/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The table of the stability tests. A row is a measure of a family; its cells are figures of the method that fails, of Box2D
   and of both builds of tuff. Each program prints the cells it knows as lines `cell: ...`, which tests/stability/page.py
   collects. */
#ifndef TUFF_STABILITY_TABLE_H
#define TUFF_STABILITY_TABLE_H

/* The family by its number in docs/stability.md, for the calls below. */
void table_family(int number, const char *name);

/* Begin a row: what is measured, with its unit. Rows appear in the order of their first printing. */
void table_row(const char *measure);

/* The row's cells; a figure is one short text, as printf makes it. method: what fails, such as "textbook". Where the two
   builds' programs print different figures of a method or of Box2D, both are shown. */
void table_fails(const char *method, const char *figure, ...);
void table_box2d(const char *figure, ...);
void table_tuff(const char *figure, ...);

#endif
