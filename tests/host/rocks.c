/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Outlines are triangulated by cutting ears, in integers, and the triangles joined again while they stay convex (Hertel and Mehlhorn): both
   cut along whole diagonals only, so that every inner edge is the same edge in both its parts. */
#include "rocks.h"

#define TURN (2.0 * 3.14159265358979323846)

/* Convex parts as lists of point numbers. */
typedef struct cut {
    rock_point points[ROCK_MAX_POINTS];
    int        point_count;
    uint8_t    lists[ROCK_MAX_POINTS][TUFF_MAX_VERTICES];
    int        sizes[ROCK_MAX_POINTS];
    int        count;
} cut;

static int64_t turn(rock_point a, rock_point b, rock_point c)
{
    return (int64_t)(b.x - a.x) * (c.y - a.y) - (int64_t)(b.y - a.y) * (c.x - a.x);
}

/* ---- cutting ---- */

static bool in_triangle(rock_point p, rock_point a, rock_point b, rock_point c)
{
    return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
}

/* Can the corner at ring[at] be cut off along a diagonal that no other point touches? */
static bool is_ear(const cut *made, const uint8_t *ring, int count, int at)
{
    const rock_point *points = made->points;
    rock_point a = points[ring[(at + count - 1) % count]], b = points[ring[at]], c = points[ring[(at + 1) % count]];
    if (turn(a, b, c) <= 0) return false;
    for (int i = 2; i < count - 1; i++) {
        if (in_triangle(points[ring[(at + i) % count]], a, b, c)) return false;
    }
    return true;
}

static void add_triangle(cut *made, uint8_t a, uint8_t b, uint8_t c)
{
    uint8_t *list = made->lists[made->count];
    list[0] = a;
    list[1] = b;
    list[2] = c;
    made->sizes[made->count++] = 3;
}

static int find_ear(const cut *made, const uint8_t *ring, int count, int first)
{
    for (int i = 0; i < count; i++) {
        if (is_ear(made, ring, count, (first + i) % count)) return (first + i) % count;
    }
    return -1;
}

static bool cut_ears(random_source *source, cut *made)
{
    uint8_t ring[ROCK_MAX_POINTS];
    int count = made->point_count;
    for (int i = 0; i < count; i++) ring[i] = (uint8_t)i;
    while (count >= 3) {
        int at = find_ear(made, ring, count, (int)random_below(source, (uint32_t)count));
        if (at < 0) return false;
        add_triangle(made, ring[(at + count - 1) % count], ring[at], ring[(at + 1) % count]);
        for (int i = at; i < count - 1; i++) ring[i] = ring[i + 1];
        count--;
    }
    return true;
}

/* ---- joining ---- */

/* Where in the list the edge from -> to begins; -1: nowhere. */
static int find_edge(const cut *made, int part, uint8_t from, uint8_t to)
{
    int size = made->sizes[part];
    for (int i = 0; i < size; i++) {
        if (made->lists[part][i] == from && made->lists[part][(i + 1) % size] == to) return i;
    }
    return -1;
}

static bool all_turn_left(const cut *made, const uint8_t *list, int size)
{
    for (int i = 0; i < size; i++) {
        if (turn(made->points[list[i]], made->points[list[(i + 1) % size]], made->points[list[(i + 2) % size]]) <= 0) return false;
    }
    return true;
}

/* Join part b to part a across the edge that begins at a's place i and b's place j, if that is convex and not too long. */
static bool join(cut *made, int a, int i, int b, int j)
{
    uint8_t list[2 * TUFF_MAX_VERTICES];
    int size = 0;
    for (int k = 1; k <= made->sizes[a]; k++) list[size++] = made->lists[a][(i + k) % made->sizes[a]];
    for (int k = 2; k < made->sizes[b]; k++) list[size++] = made->lists[b][(j + k) % made->sizes[b]];
    if (size > TUFF_MAX_VERTICES || !all_turn_left(made, list, size)) return false;
    for (int k = 0; k < size; k++) made->lists[a][k] = list[k];
    made->sizes[a] = size;
    made->count--;
    for (int k = 0; k < made->sizes[made->count]; k++) made->lists[b][k] = made->lists[made->count][k];
    made->sizes[b] = made->sizes[made->count];
    return true;
}

static bool join_at_edge(cut *made, int a, int i)
{
    uint8_t from = made->lists[a][i], to = made->lists[a][(i + 1) % made->sizes[a]];
    for (int b = a + 1; b < made->count; b++) {
        int j = find_edge(made, b, to, from);
        if (j >= 0) return join(made, a, i, b, j);
    }
    return false;
}

static void join_parts(random_source *source, cut *made, uint32_t percent)
{
    for (int a = 0; a < made->count; a++) {
        for (int i = 0; i < made->sizes[a]; i++) {
            if (random_chance(source, percent) && join_at_edge(made, a, i)) i = -1;
        }
    }
}

/* ---- baking ---- */

static bool shared(const cut *made, int part, uint8_t from, uint8_t to)
{
    for (int other = 0; other < made->count; other++) {
        if (other != part && find_edge(made, other, to, from) >= 0) return true;
    }
    return false;
}

static tuff_vec2 on_grid(rock_point p)
{
    return (tuff_vec2){ real_from_double(p.x * (double)EXACT_UNIT / ROCK_GRID), real_from_double(p.y * (double)EXACT_UNIT / ROCK_GRID) };
}

/* One part, beginning anywhere and running either way. */
static void bake_part(random_source *source, const cut *from, rock *made, int part)
{
    int size = from->sizes[part], first = (int)random_below(source, (uint32_t)size);
    bool backwards = random_chance(source, 50);
    uint32_t internal = 0;
    for (int i = 0; i < size; i++) {
        int at = (first + (backwards ? size - i : i)) % size, edge = backwards ? (at + size - 1) % size : at;
        made->vertices[part][i] = on_grid(from->points[from->lists[part][at]]);
        if (shared(from, part, from->lists[part][edge], from->lists[part][(edge + 1) % size])) internal |= (uint32_t)1 << i;
    }
    tuff_edge_normals(made->vertices[part], (uint8_t)size, made->normals[part]);
    made->parts[part] = (tuff_polygon){ made->vertices[part], made->normals[part], internal, (uint8_t)size };
}

static void bake(random_source *source, const cut *from, rock *made)
{
    made->part_count = (uint8_t)from->count;
    made->bounding_radius = 0;
    for (int part = 0; part < from->count; part++) {
        bake_part(source, from, made, part);
        tuff_real cover = random_cover(made->vertices[part], from->sizes[part]);
        if (cover > made->bounding_radius) made->bounding_radius = cover;
    }
}

bool rock_from_outline(random_source *source, rock *made, const rock_point *points, int count, uint32_t join_percent)
{
    cut parts = { .point_count = count };
    for (int i = 0; i < count; i++) parts.points[i] = points[i];
    if (!cut_ears(source, &parts)) return false;
    join_parts(source, &parts, join_percent);
    bake(source, &parts, made);
    return true;
}

/* ---- outlines ---- */

static rock_point polar(double angle, double radius)
{
    return (rock_point){ (int32_t)floor(cos(angle) * radius * ROCK_GRID + 0.5), (int32_t)floor(sin(angle) * radius * ROCK_GRID + 0.5) };
}

static int star_outline(random_source *source, rock_point *points, double size)
{
    int count = random_between(source, 5, 24);
    double rough = random_within(source, 0.1, 0.8);
    for (int i = 0; i < count; i++) {
        double angle = (i + random_within(source, 0.1, 0.9)) * TURN / count;
        points[i] = polar(angle, size * (1.0 - rough * random_fraction(source)));
    }
    return count;
}

static int spikes_outline(random_source *source, rock_point *points, double size)
{
    int spikes = random_between(source, 3, 12);
    double waist = size * random_within(source, 0.15, 0.8), start = random_within(source, 0.0, TURN);
    for (int i = 0; i < 2 * spikes; i++) points[i] = polar(start + i * TURN / (2 * spikes), i % 2 ? waist : size);
    return 2 * spikes;
}

static int ell_outline(random_source *source, rock_point *points, double size)
{
    double wide = random_within(source, 0.15, 0.85), high = random_within(source, 0.15, 0.85);
    double angle = random_chance(source, 40) ? TURN / 4 * random_below(source, 4) : random_within(source, 0.0, TURN);
    double x[6] = { -0.7, 0.7, 0.7, wide * 1.4 - 0.7, wide * 1.4 - 0.7, -0.7 };
    double y[6] = { -0.7, -0.7, high * 1.4 - 0.7, high * 1.4 - 0.7, 0.7, 0.7 };
    for (int i = 0; i < 6; i++) points[i] = polar(angle + atan2(y[i], x[i]), size * sqrt(x[i] * x[i] + y[i] * y[i]));
    return 6;
}

static int crescent_outline(random_source *source, rock_point *points, double size)
{
    int steps = random_between(source, 3, 12);
    double half = random_within(source, 1.0, 2.8), thick = random_within(source, 0.1, 0.6), start = random_within(source, 0.0, TURN);
    int count = 0;
    for (int i = 0; i <= steps; i++) points[count++] = polar(start - half + 2 * half * i / steps, size);
    for (int i = steps - 1; i > 0; i--) {
        double along = 2.0 * i / steps - 1.0;
        points[count++] = polar(start + half * along, size * (1.0 - thick * (1.0 - along * along)));
    }
    return count;
}

static int convex_outline(random_source *source, rock_point *points, double size)
{
    int count = random_between(source, 4, 20);
    double start = random_within(source, 0.0, TURN);
    for (int i = 0; i < count; i++) points[i] = polar(start + (i + random_within(source, 0.0, 0.5)) * TURN / count, size);
    return count;
}

/* Two rings of points, with a band of triangles between them. */
static void make_ring(random_source *source, rock *made, double size)
{
    cut band = { 0 };
    int sides = random_between(source, 4, 14);
    double hole = size * random_within(source, 0.3, 0.8), start = random_within(source, 0.0, TURN);
    for (int i = 0; i < sides; i++) {
        band.points[2 * i] = polar(start + i * TURN / sides, size);
        band.points[2 * i + 1] = polar(start + i * TURN / sides, hole);
    }
    band.point_count = 2 * sides;
    for (int i = 0; i < sides; i++) {
        uint8_t outer = (uint8_t)(2 * i), inner = (uint8_t)(2 * i + 1);
        uint8_t next_outer = (uint8_t)(2 * ((i + 1) % sides)), next_inner = (uint8_t)(next_outer + 1);
        add_triangle(&band, outer, next_outer, inner);
        add_triangle(&band, inner, next_outer, next_inner);
    }
    join_parts(source, &band, random_chance(source, 70) ? 100 : 30);
    bake(source, &band, made);
}

static int make_outline(random_source *source, rock_point *points, int kind, double size)
{
    switch (kind) {
    case ROCK_STAR:     return star_outline(source, points, size);
    case ROCK_SPIKES:   return spikes_outline(source, points, size);
    case ROCK_ELL:      return ell_outline(source, points, size);
    case ROCK_CRESCENT: return crescent_outline(source, points, size);
    default:            return convex_outline(source, points, size);
    }
}

void rock_make(random_source *source, rock *made, int kind, double size)
{
    rock_point points[ROCK_MAX_POINTS];
    if (kind == ROCK_RING) {
        make_ring(source, made, size);
        return;
    }
    for (;;) {
        int count = make_outline(source, points, kind, size);
        if (rock_from_outline(source, made, points, count, random_chance(source, 70) ? 100 : 30)) return;
    }
}

tuff_terrain rock_terrain(const rock *made, tuff_vec2 position)
{
    return (tuff_terrain){ position, TUFF_WHOLE(1), made->bounding_radius, made->parts, made->part_count };
}
