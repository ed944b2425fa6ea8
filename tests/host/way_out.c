/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The shortest way out of a union of convex polygons, by brute force. */
#include "way_out.h"

/* A piece of boundary: from a to b, or with b equal to a the circle of the radius about a. */
typedef struct border { way_point a, b; int owner; double distance; } border;
#define MOST_BORDERS (2 * ROCK_MAX_PARTS * 16)

static double way_cross(way_point a, way_point b)
{
    return a.x * b.y - a.y * b.x;
}

static way_point nearest_on(way_point a, way_point b, way_point p)
{
    way_point along = way_between(b, a);
    double t = way_dot(way_between(p, a), along) / way_dot(along, along);
    t = t < 0 ? 0 : t > 1 ? 1 : t;
    return (way_point){ a.x + t * along.x, a.y + t * along.y };
}

/* Distance from polygon k: negative inside. */
static double signed_distance(const way_forbidden *f, int k, way_point p)
{
    double least = HUGE_VAL;
    bool inside = true;
    for (int i = 0; i < f->counts[k]; i++) {
        way_point a = f->corners[k][i], b = f->corners[k][(i + 1) % f->counts[k]];
        double away = way_length(nearest_on(a, b, p), p);
        if (away < least) least = away;
        if (way_cross(way_between(b, a), way_between(p, a)) < 0) inside = false;
    }
    return inside ? -least : least;
}

double way_clearance(const way_forbidden *f, way_point p)
{
    double least = HUGE_VAL;
    for (int k = 0; k < f->count; k++) {
        double away = signed_distance(f, k, p) - f->radius;
        if (away < least) least = away;
    }
    return least;
}

static double border_distance(const way_forbidden *f, const border *side, way_point p)
{
    if (side->a.x == side->b.x && side->a.y == side->b.y) return fabs(way_length(side->a, p) - f->radius);
    return way_length(nearest_on(side->a, side->b, p), p);
}

static void add_border(border *list, int *count, border side)
{
    assert_true(*count < MOST_BORDERS);
    list[(*count)++] = side;
}

static int list_borders(const way_forbidden *f, border *list, way_point p)
{
    int count = 0;
    for (int k = 0; k < f->count; k++) {
        for (int i = 0; i < f->counts[k]; i++) {
            way_point a = f->corners[k][i], b = f->corners[k][(i + 1) % f->counts[k]];
            double length = way_length(a, b), nx = (b.y - a.y) / length * f->radius, ny = (a.x - b.x) / length * f->radius;
            add_border(list, &count, (border){ { a.x + nx, a.y + ny }, { b.x + nx, b.y + ny }, k, 0.0 });
            if (f->radius > 0) add_border(list, &count, (border){ a, a, k, 0.0 });
        }
    }
    for (int i = 0; i < count; i++) list[i].distance = border_distance(f, &list[i], p);
    return count;
}

static int by_distance(const void *left, const void *right)
{
    double a = ((const border *)left)->distance, b = ((const border *)right)->distance;
    return (a > b) - (a < b);
}

/* The best free candidate so far. */
typedef struct search { const way_forbidden *f; way_point from; double best; } search;

static void try_candidate(search *s, way_point candidate)
{
    double way = way_length(candidate, s->from);
    if (way < s->best && way_clearance(s->f, candidate) >= -1e-7) s->best = way;
}

static bool is_arc(const border *side)
{
    return side->a.x == side->b.x && side->a.y == side->b.y;
}

static void try_lines(search *s, const border *one, const border *other)
{
    way_point u = way_between(one->b, one->a), v = way_between(other->b, other->a);
    double turned = way_cross(u, v);
    if (fabs(turned) < 1e-12) return;
    double t = way_cross(way_between(other->a, one->a), v) / turned;
    if (t > -1e-9 && t < 1 + 1e-9) try_candidate(s, (way_point){ one->a.x + t * u.x, one->a.y + t * u.y });
}

static void try_line_and_arc(search *s, const border *line, const border *arc)
{
    way_point u = way_between(line->b, line->a), w = way_between(line->a, arc->a);
    double length = way_dot(u, u), middle = -way_dot(u, w) / length;
    double root = middle * middle - (way_dot(w, w) - s->f->radius * s->f->radius) / length;
    if (root < 0) return;
    root = sqrt(root);
    try_candidate(s, (way_point){ line->a.x + (middle - root) * u.x, line->a.y + (middle - root) * u.y });
    try_candidate(s, (way_point){ line->a.x + (middle + root) * u.x, line->a.y + (middle + root) * u.y });
}

static void try_arcs(search *s, const border *one, const border *other)
{
    way_point between = way_between(other->a, one->a);
    double square = way_dot(between, between);
    if (square == 0) return;
    double high = s->f->radius * s->f->radius / square - 0.25;
    if (high < 0) return;
    high = sqrt(high);
    way_point middle = { one->a.x + between.x / 2, one->a.y + between.y / 2 };
    try_candidate(s, (way_point){ middle.x - between.y * high, middle.y + between.x * high });
    try_candidate(s, (way_point){ middle.x + between.y * high, middle.y - between.x * high });
}

static void try_crossings(search *s, const border *one, const border *other)
{
    if (is_arc(one) && is_arc(other)) try_arcs(s, one, other);
    else if (is_arc(one)) try_line_and_arc(s, other, one);
    else if (is_arc(other)) try_line_and_arc(s, one, other);
    else try_lines(s, one, other);
}

static void try_nearest(search *s, const border *side)
{
    if (!is_arc(side)) {
        try_candidate(s, nearest_on(side->a, side->b, s->from));
        return;
    }
    double away = way_length(side->a, s->from), stretch = s->f->radius / (away > 1e-12 ? away : 1e-12);
    try_candidate(s, (way_point){ side->a.x + (s->from.x - side->a.x) * stretch, side->a.y + (s->from.y - side->a.y) * stretch });
}

/* Length of the shortest move out of the region. The end of it is the point of one border nearest to here, or where two borders cross. */
double way_shortest(const way_forbidden *f, way_point from)
{
    static border list[MOST_BORDERS];
    search s = { f, from, HUGE_VAL };
    int count = list_borders(f, list, from);
    if (way_clearance(f, from) >= 0) return 0;
    qsort(list, (size_t)count, sizeof *list, by_distance);
    for (int i = 0; i < count && list[i].distance < s.best; i++) try_nearest(&s, &list[i]);
    for (int i = 0; i < count && list[i].distance < s.best; i++) {
        for (int j = 0; j < i; j++) {
            if (list[i].owner != list[j].owner) try_crossings(&s, &list[i], &list[j]);
        }
    }
    return s.best;
}

/* ---- from the library's numbers ---- */

static int compare_points(const void *left, const void *right)
{
    const way_point *a = (const way_point *)left, *b = (const way_point *)right;
    if (a->x != b->x) return a->x < b->x ? -1 : 1;
    return (a->y > b->y) - (a->y < b->y);
}

static int half_hull(const way_point *points, int count, int step, way_point *hull)
{
    int kept = 0;
    for (int i = step > 0 ? 0 : count - 1; i >= 0 && i < count; i += step) {
        while (kept >= 2 && way_cross(way_between(hull[kept - 1], hull[kept - 2]), way_between(points[i], hull[kept - 2])) <= 1e-9) kept--;
        hull[kept++] = points[i];
    }
    return kept - 1;
}

/* One part, grown by the hull turned about; counterclockwise. */
static int grow(const tuff_polygon *part, const tuff_polygon *hull, way_point *corners)
{
    way_point sums[TUFF_MAX_VERTICES * TUFF_MAX_VERTICES], half[TUFF_MAX_VERTICES * TUFF_MAX_VERTICES + 1];
    int count = 0;
    for (int i = 0; i < part->count; i++) {
        for (int j = 0; j < (hull ? hull->count : 1); j++) {
            way_point away = hull ? way_point_of(hull->vertices[j]) : (way_point){ 0, 0 };
            sums[count++] = way_between(way_point_of(part->vertices[i]), away);
        }
    }
    qsort(sums, (size_t)count, sizeof *sums, compare_points);
    int total = half_hull(sums, count, 1, half);
    for (int i = 0; i < total; i++) corners[i] = half[i];
    int back = half_hull(sums, count, -1, half);
    for (int i = 0; i < back; i++) corners[total + i] = half[i];
    return total + back;
}

void way_forbid(way_forbidden *f, const rock *made, double radius, const tuff_polygon *hull)
{
    f->count = made->part_count;
    f->radius = hull ? 0.0 : radius;
    for (int k = 0; k < f->count; k++) f->counts[k] = grow(&made->parts[k], hull, f->corners[k]);
}
