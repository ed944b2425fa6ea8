/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Families of random shapes. Convexity is made, not hoped for: points are rounded to the build's numbers first, then the exact hull
   of the rounded points is taken. */
#include "families.h"

#define TURN 6.283185307179586

typedef struct outline {            /* points of an ellipse, in units */
    double angles[TUFF_MAX_VERTICES];
    int    count;
    double wide, high, turn, x, y;
} outline;

static tuff_vec2 outline_point(const outline *o, int i, double grid)
{
    double x = o->wide * cos(o->angles[i]), y = o->high * sin(o->angles[i]);
    double turned_x = o->x + x * cos(o->turn) - y * sin(o->turn), turned_y = o->y + x * sin(o->turn) + y * cos(o->turn);
    if (grid <= 0) return random_point_at(turned_x, turned_y);
    return random_point_at(floor(turned_x / grid + 0.5) * grid, floor(turned_y / grid + 0.5) * grid);
}

static void random_angles(random_source *source, outline *o, int count)
{
    o->count = count;
    for (int i = 0; i < count; i++) o->angles[i] = random_within(source, 0, TURN);
}

/* False: the points have no area on this grid (0: the build's own). */
static bool shape_of_outline(random_shape *shape, const outline *o, double grid)
{
    tuff_vec2 points[TUFF_MAX_VERTICES], hull[TUFF_MAX_VERTICES + 2];
    for (int i = 0; i < o->count; i++) points[i] = outline_point(o, i, grid);
    int kept = random_hull_of(points, o->count, hull);
    if (kept < 3) return false;
    for (int i = 0; i < kept; i++) shape->vertices[i] = hull[i];
    random_bake(shape, kept);
    return true;
}

static outline rock_outline(random_source *source, int most, double size)
{
    outline o = { { 0 }, 0, size, size * random_within(source, 0.4, 1), random_within(source, 0, TURN), 0, 0 };
    random_angles(source, &o, random_between(source, 3, most));
    return o;
}

static bool rock(random_source *source, random_shape *shape, double largest)
{
    outline o = rock_outline(source, TUFF_MAX_VERTICES, random_magnitude(source, 1, largest));
    return shape_of_outline(shape, &o, 0);
}

static bool needle(random_source *source, random_shape *shape, double largest)
{
    double length = random_magnitude(source, largest / 64, largest);
    outline o = { { 0 }, 0, length, length / 1000, random_chance(source, 30) ? TURN / 4 : random_within(source, 0, TURN), 0, 0 };
    random_angles(source, &o, random_between(source, 3, 8));
    return shape_of_outline(shape, &o, 0);
}

static bool tiny(random_source *source, random_shape *shape, double largest)
{
    outline o = rock_outline(source, 8, random_magnitude(source, 1.0 / 64, largest < 1 ? largest : 1));
    return shape_of_outline(shape, &o, 0);
}

/* Vertices on even steps of the grid, and the middles of some edges between them. */
static bool collinear(random_source *source, random_shape *shape, double largest)
{
    tuff_vec2 corners[TUFF_MAX_VERTICES];
    outline o = rock_outline(source, TUFF_MAX_VERTICES / 2, random_magnitude(source, 1, largest));
    if (!shape_of_outline(shape, &o, 1.0 / 512)) return false;
    int corner_count = shape->polygon.count, count = 0;
    for (int i = 0; i < corner_count; i++) corners[i] = shape->vertices[i];
    for (int i = 0; i < corner_count; i++) {
        tuff_vec2 here = corners[i], next = corners[(i + 1) % corner_count];
        shape->vertices[count++] = here;
        if (random_chance(source, 50)) continue;
        shape->vertices[count++] = (tuff_vec2){ here.x / 2 + next.x / 2, here.y / 2 + next.y / 2 };
    }
    random_bake(shape, count);
    return true;
}

static bool off_origin(random_source *source, random_shape *shape, double largest)
{
    outline o = rock_outline(source, TUFF_MAX_VERTICES, random_magnitude(source, largest / 512, largest / 3));
    o.x = random_within(source, -largest / 3, largest / 3);
    o.y = random_within(source, -largest / 3, largest / 3);
    return shape_of_outline(shape, &o, 0);
}

static bool whole_box(random_source *source, random_shape *shape, double largest)
{
    int most = (int)(largest / 1.5);
    int32_t wide = random_between(source, 1, most > 1 ? most : 1), high = random_between(source, 1, most > 1 ? most : 1);
    tuff_vec2 corner = { tuff_from_int(wide), tuff_from_int(random_chance(source, 30) ? wide : high) };
    random_box_shape(shape, corner);
    return true;
}

/* Right-angled, mostly flat: its axes turn by more than a right angle at once. */
static bool whole_triangle(random_source *source, random_shape *shape, double largest)
{
    int most = (int)(largest / 1.5);
    tuff_real wide = tuff_from_int(random_between(source, 1, most > 1 ? most : 1)), high = tuff_from_int(random_between(source, 1, 3));
    bool upright = random_chance(source, 50);
    shape->vertices[0] = (tuff_vec2){ 0, 0 };
    shape->vertices[1] = (tuff_vec2){ upright ? high : wide, 0 };
    shape->vertices[2] = (tuff_vec2){ 0, upright ? wide : high };
    random_bake(shape, 3);
    return true;
}

static bool regular(random_source *source, random_shape *shape, double largest)
{
    double size = random_magnitude(source, 1, largest);
    double angle = random_chance(source, 50) ? 0 : random_fraction(source);
    outline o = { { 0 }, random_between(source, 3, TUFF_MAX_VERTICES), size, size, angle, 0, 0 };
    for (int i = 0; i < o.count; i++) o.angles[i] = TURN * i / o.count;
    return shape_of_outline(shape, &o, 0);
}

typedef bool family(random_source *source, random_shape *shape, double largest);

void family_shape(random_source *source, random_shape *shape, double largest)
{
    static family *const families[] = { rock, rock, rock, rock, needle, tiny, collinear, off_origin, whole_box, whole_triangle, regular };
    family *chosen = families[random_below(source, sizeof families / sizeof families[0])];
    while (!chosen(source, shape, largest)) continue;
    random_renumber(source, shape->vertices, shape->polygon.count);
    random_bake(shape, shape->polygon.count);
}

void family_turned(random_shape *turned, const random_shape *shape, double angle)
{
    tuff_vec2 points[TUFF_MAX_VERTICES], hull[TUFF_MAX_VERTICES + 2];
    int count = shape->polygon.count;
    for (int i = 0; i < count; i++) {
        double x = (double)exact_real(shape->vertices[i].x), y = (double)exact_real(shape->vertices[i].y);
        points[i].x = real_from_double(x * cos(angle) - y * sin(angle));
        points[i].y = real_from_double(x * sin(angle) + y * cos(angle));
    }
    int kept = random_hull_of(points, count, hull);
    for (int i = 0; i < (kept < 3 ? count : kept); i++) turned->vertices[i] = kept < 3 ? shape->vertices[i] : hull[i];
    random_bake(turned, kept < 3 ? count : kept);
}

static bool vertices_apart(const random_shape *shape, double least)
{
    for (int i = 0; i < shape->polygon.count; i++) {
        for (int j = 0; j < i; j++) {
            exact2 gap = exact_sub(exact_vec2(shape->vertices[i]), exact_vec2(shape->vertices[j]));
            if (exact_dot(gap, gap) < (exact)(least * least)) return false;
        }
    }
    return true;
}

void family_plain_shape(random_source *source, random_shape *shape, int most, double size)
{
    for (;;) {
        outline o = rock_outline(source, most, size);
        if (shape_of_outline(shape, &o, 1.0 / 4096) && vertices_apart(shape, EXACT_UNIT / 16.0)) return;
    }
}

tuff_vec2 family_position(random_source *source)
{
    static const int32_t extents[] = { 0, 100 * 1024, 16000 * 1024, 16000 * 1024 };
    int32_t extent = extents[random_below(source, 4)];
    tuff_real x = tuff_from_q22_10(random_between(source, -extent, extent));
    return (tuff_vec2){ x, tuff_from_q22_10(random_between(source, -extent, extent)) };
}

double family_steps(random_source *source)
{
    double most = random_chance(source, 80) ? 3 : 1000;
    return random_chance(source, 20) ? 0 : random_within(source, -most, most);
}
