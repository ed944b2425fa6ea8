/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Beams through random worlds, against brute force over all pieces in exact numbers. Fixed build: every answer exact, every hit where
   the header says. Float build: the same outside of the band about touching that it is held to. */
#include <string.h>

#include "accuracy.h"
#include "worlds.h"

__extension__ typedef __int128 wide;

/* Ends relative to a piece, in steps; and the band about touching in which the float build may answer either way. */
typedef struct segment {
    exact2 a, b, d;
    exact  length, band;
} segment;

static segment make_segment(tuff_vec2 a, tuff_vec2 b, tuff_vec2 origin)
{
    segment s = { exact_sub(exact_vec2(a), exact_vec2(origin)), exact_sub(exact_vec2(b), exact_vec2(origin)), { 0, 0 }, 0, 0 };
    s.d = exact_sub(s.b, s.a);
    s.length = exact_length(s.d);
    s.band = TUFF_SCALAR == TUFF_Q16_16 ? 0 : accuracy_float_beam_band(s.length);
    return s;
}

static exact2 point_at(const segment *s, exact t)
{
    return (exact2){ s->a.x + t * s->d.x, s->a.y + t * s->d.y };
}

/* May the piece be left out, because the segment stays clear of its bounding circle by more than any rounding? */
static bool is_far(const segment *s, const tuff_terrain *piece)
{
    double ax = (double)s->a.x, ay = (double)s->a.y, dx = (double)s->d.x, dy = (double)s->d.y;
    double whole = dx * dx + dy * dy, t = whole > 0 ? -(ax * dx + ay * dy) / whole : 0;
    t = t < 0 ? 0 : t > 1 ? 1 : t;
    return hypot(ax + t * dx, ay + t * dy) > (double)exact_real(piece->bounding_radius) + (double)s->band + EXACT_UNIT;
}

/* ---- exact predicates ---- */

static exact turn(exact2 a, exact2 b, exact2 c)
{
    return exact_cross(exact_sub(b, a), exact_sub(c, a));
}

static bool in_box(exact2 a, exact2 b, exact2 p)
{
    bool x_between = a.x < b.x ? a.x <= p.x && p.x <= b.x : b.x <= p.x && p.x <= a.x;
    bool y_between = a.y < b.y ? a.y <= p.y && p.y <= b.y : b.y <= p.y && p.y <= a.y;
    return x_between && y_between;
}

/* Do the closed segments a-b and c-d meet? */
static bool segments_meet(exact2 a, exact2 b, exact2 c, exact2 d)
{
    exact ca = turn(c, d, a), cb = turn(c, d, b), ac = turn(a, b, c), ad = turn(a, b, d);
    if (((ca > 0 && cb < 0) || (ca < 0 && cb > 0)) && ((ac > 0 && ad < 0) || (ac < 0 && ad > 0))) return true;
    return (ca == 0 && in_box(c, d, a)) || (cb == 0 && in_box(c, d, b)) || (ac == 0 && in_box(a, b, c)) || (ad == 0 && in_box(a, b, d));
}

static exact2 corner(const tuff_polygon *polygon, int i)
{
    return exact_vec2(polygon->vertices[i % polygon->count]);
}

static bool in_polygon(const tuff_polygon *polygon, exact2 p, bool closed)
{
    bool left = false, right = false, on = false;
    for (int i = 0; i < polygon->count; i++) {
        exact side = turn(corner(polygon, i), corner(polygon, i + 1), p);
        if (side > 0) left = true;
        else if (side < 0) right = true;
        else on = true;
    }
    return !(left && right) && (closed || !on);
}

static bool meets_polygon(const segment *s, const tuff_polygon *polygon)
{
    if (in_polygon(polygon, s->a, true)) return true;
    for (int i = 0; i < polygon->count; i++) {
        if (segments_meet(s->a, s->b, corner(polygon, i), corner(polygon, i + 1))) return true;
    }
    return false;
}

/* |d x a| <= radius * |d|: squares of 121 bits in the fixed build, where all are whole; |d x a| beyond 62 bits is too far anyway. */
static bool line_reaches(const segment *s, exact radius)
{
    exact across = exact_abs(exact_cross(s->d, s->a));
    if (across >= (exact)((uint64_t)1 << 62)) return false;
    if (TUFF_SCALAR == TUFF_FLOAT) return across * across <= radius * radius * exact_dot(s->d, s->d);
    return (wide)across * (wide)across <= (wide)(radius * radius) * (wide)exact_dot(s->d, s->d);
}

static bool meets_circle(const segment *s, exact radius)
{
    exact from_a = -exact_dot(s->a, s->d), whole = exact_dot(s->d, s->d);
    if (exact_dot(s->a, s->a) <= radius * radius || exact_dot(s->b, s->b) <= radius * radius) return true;
    return from_a > 0 && from_a < whole && line_reaches(s, radius);
}

static bool meets_piece(const segment *s, const tuff_terrain *piece)
{
    if (piece->parts == NULL) return meets_circle(s, exact_real(piece->radius));
    for (int k = 0; k < piece->part_count; k++) {
        if (meets_polygon(s, &piece->parts[k])) return true;
    }
    return false;
}

/* ---- distances, for the band of the float build ---- */

static exact point_to_segment(exact2 p, exact2 a, exact2 b)
{
    exact2 d = exact_sub(b, a), w = exact_sub(p, a);
    exact whole = exact_dot(d, d), t = whole > 0 ? exact_dot(w, d) / whole : 0;
    t = t < 0 ? 0 : t > 1 ? 1 : t;
    return exact_length((exact2){ w.x - t * d.x, w.y - t * d.y });
}

static exact lesser(exact a, exact b)
{
    return a < b ? a : b;
}

/* How far the segment stays away from the piece; 0: they meet. */
static exact distance_to_piece(const segment *s, const tuff_terrain *piece)
{
    if (meets_piece(s, piece)) return 0;
    if (piece->parts == NULL) return point_to_segment((exact2){ 0, 0 }, s->a, s->b) - exact_real(piece->radius);
    exact least = (exact)1e30;
    for (int k = 0; k < piece->part_count; k++) {
        for (int i = 0; i < piece->parts[k].count; i++) {
            exact2 c = corner(&piece->parts[k], i), d = corner(&piece->parts[k], i + 1);
            least = lesser(least, point_to_segment(c, s->a, s->b));
            least = lesser(least, lesser(point_to_segment(s->a, c, d), point_to_segment(s->b, c, d)));
        }
    }
    return least;
}

/* The stretch of the segment, from 0 to *high at most, that lies in the closed polygon. False: none. */
static bool clip(const segment *s, const tuff_polygon *polygon, exact *low, exact *high)
{
    exact way_round = 0;
    for (int i = 1; i + 1 < polygon->count; i++) way_round += turn(corner(polygon, 0), corner(polygon, i), corner(polygon, i + 1));
    for (int i = 0; i < polygon->count; i++) {
        exact2 from = corner(polygon, i), edge = exact_sub(corner(polygon, i + 1), from);
        exact inside = exact_cross(edge, exact_sub(s->a, from)), gain = exact_cross(edge, s->d);
        if (way_round < 0) {
            inside = -inside;
            gain = -gain;
        }
        if (gain > 0 && -inside / gain > *low) *low = -inside / gain;
        else if (gain < 0 && -inside / gain < *high) *high = -inside / gain;
        else if (gain == 0 && inside < 0) return false;
    }
    return *low <= *high;
}

/* Is a point of the piece at least so far from its whole outline? */
static bool is_deep(const tuff_terrain *piece, exact2 p, exact depth)
{
    for (int k = 0; k < piece->part_count; k++) {
        const tuff_polygon *part = &piece->parts[k];
        for (int i = 0; i < part->count; i++) {
            if (part->internal_edges >> i & 1) continue;
            if (point_to_segment(p, corner(part, i), corner(part, i + 1)) < depth) return false;
        }
    }
    return true;
}

/* Does the segment from 0 to end come that deep into the piece? Looked for at nine points of its way through each part. */
static bool runs_deep(const segment *s, const tuff_terrain *piece, exact depth, exact end)
{
    segment cut = *s;
    if (end < 0) return false;
    cut.b = point_at(s, end);
    cut.d = exact_sub(cut.b, cut.a);
    if (piece->parts == NULL) return exact_real(piece->radius) > depth && meets_circle(&cut, exact_real(piece->radius) - depth);
    for (int k = 0; k < piece->part_count; k++) {
        exact low = 0, high = end;
        bool crosses = clip(s, &piece->parts[k], &low, &high);
        for (int i = 0; crosses && i <= 8; i++) {
            if (is_deep(piece, point_at(s, low + (high - low) * i / 8), depth)) return true;
        }
    }
    return false;
}

/* ---- where a piece is entered ---- */

/* Earliest t at which the segment, known to start outside, meets the edge c-d; 2: never. */
static exact edge_entry(const segment *s, exact2 c, exact2 d)
{
    if (!segments_meet(s->a, s->b, c, d)) return 2;
    exact a_side = turn(c, d, s->a), b_side = turn(c, d, s->b);
    if (a_side != b_side) return a_side / (a_side - b_side);
    exact whole = exact_dot(s->d, s->d);
    exact to_c = exact_dot(exact_sub(c, s->a), s->d) / whole, to_d = exact_dot(exact_sub(d, s->a), s->d) / whole;
    exact first = lesser(to_c, to_d);
    return first > 0 ? first : 0;
}

static exact circle_entry(const segment *s, exact radius)
{
    exact whole = exact_dot(s->d, s->d), across = exact_cross(s->d, s->a);
    exact under_root = radius * radius * whole - across * across;
    return (-exact_dot(s->a, s->d) - exact_sqrt(under_root > 0 ? under_root : 0)) / whole;
}

static bool starts_inside(const segment *s, const tuff_terrain *piece)
{
    if (piece->parts == NULL) return exact_dot(s->a, s->a) <= exact_real(piece->radius) * exact_real(piece->radius);
    for (int k = 0; k < piece->part_count; k++) {
        if (in_polygon(&piece->parts[k], s->a, true)) return true;
    }
    return false;
}

/* For a segment that meets the piece. */
static exact piece_entry(const segment *s, const tuff_terrain *piece)
{
    exact first = 2;
    if (starts_inside(s, piece)) return 0;
    if (piece->parts == NULL) return circle_entry(s, exact_real(piece->radius));
    for (int k = 0; k < piece->part_count; k++) {
        for (int i = 0; i < piece->parts[k].count; i++) {
            first = lesser(first, edge_entry(s, corner(&piece->parts[k], i), corner(&piece->parts[k], i + 1)));
        }
    }
    return first;
}

/* ---- is this normal right? ---- */

static bool near_unit(tuff_unit2 n, exact2 wanted, exact tolerance)
{
    exact2 off = exact_sub(exact_unit2(n), wanted);
    return exact_length(off) <= tolerance;
}

static bool is_against(tuff_unit2 n, const segment *s)
{
    if (s->length == 0) return near_unit(n, (exact2){ 1, 0 }, 0);
    return near_unit(n, (exact2){ -s->d.x / s->length, -s->d.y / s->length }, (exact)3e-7);
}

/* The normal of an edge that passes this near to the point. Fixed build: an outline edge's, bit for bit. Float build: where a seam ends on
   the outline the rounding may choose the seam, and of edges nearly in line the neighbor. */
static bool is_edge_normal(tuff_unit2 n, const tuff_terrain *piece, exact2 p, exact tolerance)
{
    const exact off = TUFF_SCALAR == TUFF_Q16_16 ? 0 : (exact)0.02;
    for (int k = 0; k < piece->part_count; k++) {
        const tuff_polygon *part = &piece->parts[k];
        for (int i = 0; i < part->count; i++) {
            if ((part->internal_edges >> i & 1) && TUFF_SCALAR == TUFF_Q16_16) continue;
            if (!near_unit(n, exact_unit2(part->normals[i]), off)) continue;
            if (point_to_segment(p, corner(part, i), corner(part, i + 1)) <= tolerance) return true;
        }
    }
    return false;
}

static bool normal_right(const tuff_beam_hit *hit, const segment *s, const tuff_terrain *piece, exact tolerance)
{
    exact2 p = point_at(s, exact_unit(hit->fraction));
    if (starts_inside(s, piece) && TUFF_SCALAR == TUFF_Q16_16) return is_against(hit->normal, s);
    if (hit->fraction == 0 && is_against(hit->normal, s)) return true;
    if (piece->parts != NULL) return is_edge_normal(hit->normal, piece, p, tolerance);
    exact away = exact_length(p);
    if (away == 0) return true;
    return near_unit(hit->normal, (exact2){ p.x / away, p.y / away }, 2 * tolerance / away + (exact)1e-6);
}

/* ---- a hit against brute force ---- */

static bool is_twin(const tuff_terrain *a, const tuff_terrain *b)
{
    return a->parts == b->parts && a->radius == b->radius && same_point(a->position, b->position);
}

/* Of equal pieces, and of those that the beam starts in, the lowest is hit. */
static bool lowest_of_equals(const world_fixture *w, tuff_vec2 a, tuff_vec2 b, int piece)
{
    for (int i = 0; i < piece; i++) {
        if (!world_present(w, i)) continue;
        if (is_twin(&w->pieces[i], &w->pieces[piece])) return false;
        segment s = make_segment(a, b, w->pieces[i].position);
        if (TUFF_SCALAR == TUFF_Q16_16 && starts_inside(&s, &w->pieces[i])) return false;
    }
    return true;
}

/* Is this where the piece is entered? A grazed circle is entered at a point that the least rounding moves far along the beam: there its
   surface decides. */
static bool entered_at(const segment *s, const tuff_terrain *piece, exact at, exact tolerance)
{
    if (exact_abs(piece_entry(s, piece) - at) * s->length <= tolerance) return true;
    return piece->parts == NULL && exact_abs(exact_length(point_at(s, at)) - exact_real(piece->radius)) <= tolerance;
}

static bool entered_before(const segment *s, const tuff_terrain *piece, exact at, exact tolerance)
{
    if ((piece_entry(s, piece) - at) * s->length >= -tolerance) return false;
    return piece->parts != NULL || runs_deep(s, piece, tolerance, at - tolerance / s->length);
}

static bool fixed_hit_right(const world_fixture *w, tuff_vec2 a, tuff_vec2 b, const tuff_beam_hit *hit)
{
    segment s = make_segment(a, b, w->pieces[hit->piece].position);
    exact tolerance = 2 + s.length / 268435456, at = exact_unit(hit->fraction);
    if (!meets_piece(&s, &w->pieces[hit->piece])) return false;
    if (!entered_at(&s, &w->pieces[hit->piece], at, tolerance)) return false;
    for (int i = 0; i < WORLD_MOST; i++) {
        segment other = make_segment(a, b, w->pieces[i].position);
        if (!world_present(w, i) || is_far(&other, &w->pieces[i]) || !meets_piece(&other, &w->pieces[i])) continue;
        if (entered_before(&other, &w->pieces[i], at, tolerance)) return false;
    }
    return normal_right(hit, &s, &w->pieces[hit->piece], tolerance);
}

/* The fraction is rounded too, and a beam that grazes an edge meets it at a point that the least rounding moves along both: a few bands. */
static bool float_hit_right(const world_fixture *w, tuff_vec2 a, tuff_vec2 b, const tuff_beam_hit *hit)
{
    segment s = make_segment(a, b, w->pieces[hit->piece].position);
    exact at = exact_unit(hit->fraction), back = s.length > 0 ? at - 4 * s.band / s.length : -1;
    segment stop = s;
    stop.a = stop.b = point_at(&s, at);
    stop.d = (exact2){ 0, 0 };
    if (distance_to_piece(&stop, &w->pieces[hit->piece]) > 4 * s.band) return false;
    for (int i = 0; i < WORLD_MOST; i++) {
        segment other = make_segment(a, b, w->pieces[i].position);
        if (world_present(w, i) && !is_far(&other, &w->pieces[i]) && runs_deep(&other, &w->pieces[i], 4 * s.band, back)) return false;
    }
    return normal_right(hit, &s, &w->pieces[hit->piece], 8 * s.band);
}

static bool hit_right(const world_fixture *w, tuff_vec2 a, tuff_vec2 b, const tuff_beam_hit *hit)
{
    if (hit->piece >= WORLD_MOST || !world_present(w, hit->piece)) return false;
    if (exact_unit(hit->fraction) < 0 || exact_unit(hit->fraction) > 1) return false;
    if (!lowest_of_equals(w, a, b, hit->piece)) return false;
    return TUFF_SCALAR == TUFF_Q16_16 ? fixed_hit_right(w, a, b, hit) : float_hit_right(w, a, b, hit);
}

/* Must some piece be hit; must none be? In the fixed build always one of the two. */
static void brute_force(const world_fixture *w, tuff_vec2 a, tuff_vec2 b, bool *must, bool *must_not)
{
    *must = false;
    *must_not = true;
    for (int i = 0; i < WORLD_MOST; i++) {
        segment s = make_segment(a, b, w->pieces[i].position);
        if (!world_present(w, i) || is_far(&s, &w->pieces[i])) continue;
        bool meets = meets_piece(&s, &w->pieces[i]);
        if (TUFF_SCALAR == TUFF_Q16_16 ? meets : runs_deep(&s, &w->pieces[i], s.band, 1)) *must = true;
        if (TUFF_SCALAR == TUFF_Q16_16 ? meets : distance_to_piece(&s, &w->pieces[i]) <= s.band) *must_not = false;
    }
}

static const char *beam_fault(world_fixture *w, tuff_vec2 a, tuff_vec2 b, bool *blocked)
{
    tuff_beam_hit hit, untouched;
    bool must, must_not;
    memset(&hit, 77, sizeof hit);
    memset(&untouched, 77, sizeof untouched);
    brute_force(w, a, b, &must, &must_not);
    *blocked = tuff_segment_terrain_intersect(&w->world, a, b);
    if ((must && !*blocked) || (must_not && *blocked)) return *blocked ? "blocked by nothing" : "not blocked";
    if (tuff_segment_terrain_intersect(&w->world, b, a) != *blocked) return "the ends cannot be swapped";
    if (tuff_segment_terrain_first_hit(&w->world, a, b, &hit) != *blocked) return "hit and blocked disagree";
    if (!*blocked) return memcmp(&hit, &untouched, sizeof hit) == 0 ? NULL : "the hit was touched";
    return hit_right(w, a, b, &hit) ? NULL : "the hit is wrong";
}

/* The index makes no difference to a beam: the same bits as without, if it holds every piece. */
static const char *index_fault(world_fixture *w, tuff_vec2 a, tuff_vec2 b)
{
    tuff_beam_hit indexed = { 0, { 0, 0 }, 0 }, linear = { 0, { 0, 0 }, 0 };
    for (int i = 0; i < w->world.terrain_count; i++) {
        if (w->pieces[i].bounding_radius > 0 && !world_present(w, i)) return NULL;
    }
    bool found = tuff_segment_terrain_first_hit(&w->world, a, b, &indexed);
    w->world.chunks = NULL;
    bool scanned = tuff_segment_terrain_first_hit(&w->world, a, b, &linear);
    w->world.chunks = &w->chunks;
    bool same = found == scanned && indexed.fraction == linear.fraction && indexed.piece == linear.piece &&
                same_normal(indexed.normal, linear.normal);
    return same ? NULL : "the index makes a difference";
}

/* ---- beams ---- */

typedef struct beam { tuff_vec2 a, b; } beam;

static tuff_vec2 some_vertex(random_source *source, const world_fixture *w)
{
    const tuff_terrain *piece = &w->pieces[random_below(source, WORLD_MOST)];
    if (piece->parts == NULL) return piece->position;
    const tuff_polygon *part = &piece->parts[random_below(source, piece->part_count)];
    tuff_vec2 v = part->vertices[random_below(source, part->count)];
    double x = units_of(piece->position.x) + units_of(v.x), y = units_of(piece->position.y) + units_of(v.y);
    return random_point_at(world_clamped(x), world_clamped(y));
}

/* A multiple of the pitch. */
static tuff_real border_near(const world_fixture *w, tuff_real a)
{
    double pitch = (double)(1u << w->chunks.pitch_log2);
    return random_point_at(world_clamped(floor(units_of(a) / pitch + 0.5) * pitch), 0).x;
}

/* From p through q and on. */
static tuff_vec2 beyond(tuff_vec2 p, tuff_vec2 q, double more)
{
    double x = units_of(q.x) + (units_of(q.x) - units_of(p.x)) * more, y = units_of(q.y) + (units_of(q.y) - units_of(p.y)) * more;
    return random_point_at(world_clamped(x), world_clamped(y));
}

static beam make_beam(random_source *source, const world_fixture *w)
{
    beam made = { world_point(source, w, 1.5), world_point(source, w, 1.5) };
    switch (random_below(source, 10)) {
    case 0:  made.b = made.a; break;
    case 1:  made.a = some_vertex(source, w); made.b = random_chance(source, 30) ? made.a : some_vertex(source, w); break;
    case 2:  made.b = beyond(made.a, some_vertex(source, w), random_fraction(source)); break;
    case 3:  made.a.x = made.b.x = border_near(w, made.a.x); break;
    case 4:  made.a.y = made.b.y = border_near(w, made.a.y); break;
    case 5:
        made.a = (tuff_vec2){ border_near(w, made.a.x), border_near(w, made.a.y) };
        made.b = (tuff_vec2){ border_near(w, made.b.x), border_near(w, made.b.y) };
        break;
    case 6:     /* through the whole world; in chunks of a few units that is a long walk */
        if (w->chunks.pitch_log2 < 5 && random_chance(source, 95)) break;
        made.a = random_point(source, 32767.9);
        made.b = beyond(made.a, made.b, 1.0);
        break;
    case 7:  made.b = (tuff_vec2){ made.a.x + TUFF_REAL_RAW(256), made.a.y }; break;
    default: break;
    }
    return made;
}

/* The index knows of every move. */
static bool tell_all(random_source *source, world_fixture *w)
{
    for (int i = 0; i < WORLD_MOST; i++) {
        if (w->shadows[i].held && !world_told(w, i) && !world_tell(source, w, i)) return false;
    }
    return true;
}

static void test_beams_stop_at_what_brute_force_finds(void **state)
{
    static world_fixture w;
    random_run run = random_cases(__func__, 61, 1800);
    uint32_t beams = 0, blocked = 0;
    (void)state;
    for (uint32_t i = run.first; i < run.end; i++) {
        random_source source = random_stream(run.seed, i);
        world_make(&source, &w);
        world_add_twins(&source, &w, 3);
        if (random_chance(&source, 60)) {
            for (int k = 0; k < WORLD_MOST; k++) assert_true(world_tell(&source, &w, k));
        }
        for (int step = 0; step < 40; step++) {
            bool hit = false, edited = world_edit(&source, &w) && tell_all(&source, &w);
            beam b = make_beam(&source, &w);
            const char *fault = edited ? beam_fault(&w, b.a, b.b, &hit) : "the index answered an edit wrongly";
            if (!fault) fault = index_fault(&w, b.a, b.b);
            beams++;
            blocked += hit;
            if (!fault) continue;
            random_fail(&run, i, "step %d: from (%.17g, %.17g) to (%.17g, %.17g): %s", step,
                        units_of(b.a.x), units_of(b.a.y), units_of(b.b.x), units_of(b.b.y), fault);
        }
    }
    print_message("figures: " EXACT_BUILD " beams: %lu beams, %lu of them blocked\n", (unsigned long)beams, (unsigned long)blocked);
    assert_true(blocked > 0);
}

/* ---- the walk along the line ---- */

/* A single ball, as large as its chunk at most, and beams that pass just inside of its surface, or just outside: the walk over the chunks
   must come by wherever the exact test says that there is something to hit. */
static void test_beams_meet_what_they_only_graze(void **state)
{
    random_run run = random_cases(__func__, 64, 150000);
    uint32_t grazed = 0;
    (void)state;
    for (uint32_t i = run.first; i < run.end; i++) {
        uint16_t buckets[8];
        tuff_chunk_entry entries[1];
        random_source source = random_stream(run.seed, i);
        tuff_chunks chunks = { buckets, entries, 8, 1, (uint16_t)random_between(&source, 0, 10), 0, 0, false };
        double most = (double)(1u << chunks.pitch_log2) * (random_chance(&source, 30) ? 1.0 : random_fraction(&source));
        tuff_real radius = random_point_at(most < 1024.0 ? most : 1024.0, 0).x;
        tuff_terrain ball = { random_point(&source, random_magnitude(&source, 1.0, 30000.0)), radius, radius, NULL, 0 };
        tuff_world world = { &ball, 1, &chunks, NULL, 0, TUFF_ORDER_ITERATION };
        double longest = fmin(60000.0, (double)(1u << chunks.pitch_log2) * 1000.0), angle = random_within(&source, 0.0, 6.2831853);
        double ahead = random_magnitude(&source, 1.0, longest), behind = random_magnitude(&source, 1.0, longest);
        if (random_chance(&source, 30)) angle = 0.78539816 * random_below(&source, 8);
        double aside = units_of(radius) * (random_chance(&source, 50) ? 0.9999 : random_within(&source, -1.01, 1.01));
        double x = units_of(ball.position.x) - sin(angle) * aside, y = units_of(ball.position.y) + cos(angle) * aside;
        beam b = { random_point_at(world_clamped(x + cos(angle) * ahead), world_clamped(y + sin(angle) * ahead)),
                   random_point_at(world_clamped(x - cos(angle) * behind), world_clamped(y - sin(angle) * behind)) };
        assert_int_equal(tuff_world_index(&world), 0);
        bool indexed = tuff_segment_terrain_intersect(&world, b.a, b.b);
        world.chunks = NULL;
        bool scanned = tuff_segment_terrain_intersect(&world, b.a, b.b);
        grazed += scanned;
        if (indexed != scanned) random_fail(&run, i, "the walk along the line missed the ball");
    }
    assert_true(grazed > 0);
}

/* ---- seams ---- */

/* A beam across a rock, through a vertex or along an edge of its parts: none slips through where parts meet. */
static void test_no_beam_slips_between_parts(void **state)
{
    static rock made;
    random_run run = random_cases(__func__, 62, 40000);
    (void)state;
    for (uint32_t i = run.first; i < run.end; i++) {
        random_source source = random_stream(run.seed, i);
        double size = random_magnitude(&source, 4.0, 900.0);
        rock_make(&source, &made, random_chance(&source, 50) ? ROCK_CUT_CONVEX : ROCK_STAR, size);
        tuff_terrain piece = rock_terrain(&made, random_point(&source, random_chance(&source, 50) ? 10.0 : 20000.0));
        const tuff_polygon *part = &made.parts[random_below(&source, made.part_count)];
        uint32_t at = random_below(&source, part->count);
        tuff_vec2 v = part->vertices[at], next = part->vertices[(at + 1) % part->count];
        double t = random_chance(&source, 50) ? 0.0 : random_fraction(&source), angle = random_within(&source, 0.0, 6.2831853);
        double x = units_of(v.x) + (units_of(next.x) - units_of(v.x)) * t, y = units_of(v.y) + (units_of(next.y) - units_of(v.y)) * t;
        double dx = cos(angle) * size * 3, dy = sin(angle) * size * 3;
        if (random_chance(&source, 30)) {
            dx = (units_of(next.x) - units_of(v.x)) * 10;
            dy = (units_of(next.y) - units_of(v.y)) * 10;
        }
        beam b = { random_point_at(units_of(piece.position.x) + x - dx, units_of(piece.position.y) + y - dy),
                   random_point_at(units_of(piece.position.x) + x + dx, units_of(piece.position.y) + y + dy) };
        segment s = make_segment(b.a, b.b, piece.position);
        tuff_world world = { &piece, 1, NULL, NULL, 0, TUFF_ORDER_ITERATION };
        bool must = TUFF_SCALAR == TUFF_Q16_16 ? meets_piece(&s, &piece) : runs_deep(&s, &piece, s.band, 1);
        if (!must || tuff_segment_terrain_intersect(&world, b.a, b.b)) continue;
        random_fail(&run, i, "a beam from (%.17g, %.17g) to (%.17g, %.17g) slipped through",
                    units_of(b.a.x), units_of(b.a.y), units_of(b.b.x), units_of(b.b.y));
    }
}

#if TUFF_SCALAR == TUFF_Q16_16
/* Boxes and triangles that share edges and corners exactly, as pieces of their own: a beam to a shared point is stopped from every side. */
static void test_no_beam_slips_between_pieces_that_share_an_edge(void **state)
{
    static random_shape halves[2];
    tuff_terrain pieces[8];
    random_run run = random_cases(__func__, 63, 20000);
    (void)state;
    for (uint32_t i = run.first; i < run.end; i++) {
        random_source source = random_stream(run.seed, i);
        tuff_vec2 size = { random_between(&source, 2, 200 * EXACT_UNIT), random_between(&source, 2, 200 * EXACT_UNIT) };
        tuff_vec2 corners[4] = { { 0, 0 }, { size.x, 0 }, size, { 0, size.y } };
        for (int k = 0; k < 3; k++) halves[0].vertices[k] = corners[k];
        for (int k = 0; k < 3; k++) halves[1].vertices[k] = corners[(k + 2) % 4];
        random_bake(&halves[0], 3);
        random_bake(&halves[1], 3);
        tuff_vec2 middle = { random_between(&source, -2000000000, 2000000000), random_between(&source, -2000000000, 2000000000) };
        for (int k = 0; k < 8; k++) {
            const random_shape *half = &halves[k & 1];
            tuff_vec2 position = { middle.x - (k & 2 ? size.x : 0), middle.y - (k & 4 ? size.y : 0) };
            pieces[k] = (tuff_terrain){ position, half->bounding_radius, half->bounding_radius, &half->polygon, 1 };
        }
        tuff_world world = { pieces, 8, NULL, NULL, 0, TUFF_ORDER_ITERATION };
        /* Anything that ends in the block is stopped, in the middle too, where six pieces meet. */
        tuff_vec2 end = random_chance(&source, 40) ? middle : (tuff_vec2){ middle.x - size.x + random_between(&source, 0, 2 * size.x),
                                                                           middle.y - size.y + random_between(&source, 0, 2 * size.y) };
        tuff_vec2 away = { (int32_t)random_bits(&source), (int32_t)random_bits(&source) };
        tuff_beam_hit hit;
        bool point = tuff_segment_terrain_intersect(&world, end, end), from = tuff_segment_terrain_intersect(&world, end, away);
        bool to = tuff_segment_terrain_intersect(&world, away, end), found = tuff_segment_terrain_first_hit(&world, away, end, &hit);
        if (!(point && from && to && found)) random_fail(&run, i, "a beam slipped between pieces that share an edge");
    }
}
#endif

/* ---- single facts ---- */

static void test_beams_with_ends_out_of_a_world_hit_nothing(void **state)
{
    tuff_beam_hit hit;
    tuff_world empty = { NULL, 5, NULL, NULL, 0, 0 };
    (void)state;
    assert_false(tuff_segment_terrain_intersect(NULL, (tuff_vec2){ 0, 0 }, (tuff_vec2){ 0, 0 }));
    assert_false(tuff_segment_terrain_first_hit(NULL, (tuff_vec2){ 0, 0 }, (tuff_vec2){ 0, 0 }, &hit));
    assert_false(tuff_segment_terrain_intersect(&empty, (tuff_vec2){ 0, 0 }, (tuff_vec2){ 0, 0 }));
    assert_false(tuff_segment_terrain_first_hit(&empty, (tuff_vec2){ 0, 0 }, (tuff_vec2){ 0, 0 }, &hit));
}

static void test_a_start_inside_is_hit_at_once(void **state)
{
    tuff_terrain ball = { { TUFF_WHOLE(100), 0 }, TUFF_WHOLE(5), TUFF_WHOLE(5), NULL, 0 };
    tuff_world world = { &ball, 1, NULL, NULL, 0, 0 };
    tuff_beam_hit hit;
    (void)state;
    assert_true(tuff_segment_terrain_first_hit(&world, (tuff_vec2){ TUFF_WHOLE(101), 0 }, (tuff_vec2){ TUFF_WHOLE(200), 0 }, &hit));
    assert_true(hit.fraction == 0 && hit.piece == 0);
    assert_true(hit.normal.x == -TUFF_UNIT_RATIO(1, 1) && hit.normal.y == 0);
    assert_true(tuff_segment_terrain_first_hit(&world, ball.position, ball.position, &hit));
    assert_true(hit.fraction == 0 && hit.normal.x == TUFF_UNIT_RATIO(1, 1) && hit.normal.y == 0);
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_beams_stop_at_what_brute_force_finds),
        cmocka_unit_test(test_beams_meet_what_they_only_graze),
        cmocka_unit_test(test_no_beam_slips_between_parts),
#if TUFF_SCALAR == TUFF_Q16_16
        cmocka_unit_test(test_no_beam_slips_between_pieces_that_share_an_edge),
#endif
        cmocka_unit_test(test_beams_with_ends_out_of_a_world_hit_nothing),
        cmocka_unit_test(test_a_start_inside_is_hit_at_once),
    };
    (void)argc;
    random_begin(argv);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
