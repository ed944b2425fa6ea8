/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Family 4, thin and degenerate shapes, as obstacles and as hulls: needles 1:1000, triangles 1 LSB high and less, vertices in line,
   vertices twice, rocks of 1 unit and of 1024, 32 vertices. Unchecked, they are held to the accuracy of all shapes; checked,
   the fault is named. Where vertices coincide, the truth is that of the shape without the copies. */
#include "accuracy.h"
#include "handed.h"
#include "naive.h"
#include "picture.h"
#include "pieces.h"
#include "table.h"

typedef enum thin_kind { NEEDLE, SLIVER, IN_LINE, TWICE, ONE_UNIT, LARGE, FULL, KINDS } thin_kind;

static const char *const kind_names[KINDS] = { "needles 1:1000", "triangles of 1 LSB and less", "vertices in line",
                                               "vertices twice", "rocks of 1 unit", "rocks of 1024 units", "32 vertices" };

typedef struct thin {               /* not to be copied */
    random_shape   plain;           /* no vertex twice */
    random_shape   given;           /* what the library gets */
    oracle_polygon exact;
} thin;

/* ---- shapes ---- */

static void make_needle(random_source *source, random_shape *shape, double size)
{
    double length = size * random_within(source, 0.5, 0.99), angle = random_chance(source, 30) ? 0 : random_within(source, 0, TURN);
    random_ellipse_shape(source, shape, random_between(source, 3, 8), length, length / 1000, angle, 0, 0);
}

/* A base of 2 to 64 units on a grid that float holds too, and a point one step beside it: 1 LSB high where the base lies along
   an axis, less elsewhere. */
static bool try_sliver(random_source *source, random_shape *shape, double size)
{
    int32_t most = (int32_t)((size < 64 ? size : 64) * 32768), wide = random_between(source, 65536, most);
    int32_t high = random_chance(source, 50) ? 0 : random_between(source, -most, most);
    double share = random_fraction(source) / (random_chance(source, 30) ? 1000 : 1);
    bool upright = random_chance(source, 50);
    const int32_t points[3][2] = { { 0, 0 }, { wide, high }, { (int32_t)(wide * share), (int32_t)floor(high * share) + 1 } };
    for (int i = 0; i < 3; i++) {
        tuff_real along = TUFF_REAL_RAW(points[i][0] - wide / 2), up = TUFF_REAL_RAW(points[i][1] - high / 2);
        shape->vertices[i] = upright ? (tuff_vec2){ up, along } : (tuff_vec2){ along, up };
    }
    random_bake(shape, 3);
    return exact_turn(shape->vertices[0], shape->vertices[1], shape->vertices[2]) != 0;
}

static void make_sliver(random_source *source, random_shape *shape, double size)
{
    while (!try_sliver(source, shape, size)) continue;
}

/* The middles of all edges become vertices. */
static void make_in_line(random_source *source, random_shape *shape, double size)
{
    tuff_vec2 corners[TUFF_MAX_VERTICES];
    family_plain_shape(source, shape, 8, size * random_within(source, 0.1, 0.9));
    int count = shape->polygon.count;
    for (int i = 0; i < count; i++) corners[i] = shape->vertices[i];
    for (int i = 0; i < count; i++) {
        tuff_vec2 here = corners[i], next = corners[(i + 1) % count];
        shape->vertices[2 * i] = here;
        shape->vertices[2 * i + 1] = (tuff_vec2){ here.x / 2 + next.x / 2, here.y / 2 + next.y / 2 };
    }
    random_bake(shape, 2 * count);
}

static void make_rock(random_source *source, random_shape *shape, double size)
{
    random_rock_shape(source, shape, 16, size * random_within(source, 0.1, 0.99));
}

static void make_full(random_source *source, random_shape *shape, double size)
{
    double radius = size * random_within(source, 0.5, 0.99);
    random_ellipse_shape(source, shape, TUFF_MAX_VERTICES, radius, radius * random_within(source, 0.4, 1), 0, 0, 0);
}

/* What a vertex may be doubled of. */
static void make_any(random_source *source, random_shape *shape, double size)
{
    static void (*const makers[])(random_source *, random_shape *, double) = { make_needle, make_sliver, make_in_line, make_rock };
    makers[random_below(source, 4)](source, shape, size);
}

static void make_plain(random_source *source, random_shape *shape, thin_kind kind, double size)
{
    switch (kind) {
    case NEEDLE:   make_needle(source, shape, size); break;
    case SLIVER:   make_sliver(source, shape, size); break;
    case IN_LINE:  make_in_line(source, shape, size); break;
    case TWICE:    make_any(source, shape, size); break;
    case ONE_UNIT: random_rock_shape(source, shape, 8, 1); break;
    case LARGE:    random_rock_shape(source, shape, TUFF_MAX_VERTICES, size); break;
    default:       make_full(source, shape, size); break;
    }
}

/* Up to three copies of the first vertex and of some others, behind them. */
static int with_copies(random_source *source, const random_shape *plain, tuff_vec2 *vertices)
{
    int count = 0, room = TUFF_MAX_VERTICES - plain->polygon.count;
    for (int i = 0; i < plain->polygon.count; i++) {
        int copies = i == 0 || random_chance(source, 40) ? random_between(source, 1, 3) : 0;
        if (copies > room) copies = room;
        room -= copies;
        for (int k = 0; k <= copies; k++) vertices[count++] = plain->vertices[i];
    }
    return count;
}

static void make_thin(random_source *source, thin *t, thin_kind kind, double size)
{
    make_plain(source, &t->plain, kind, size);
    int count = t->plain.polygon.count;
    for (int i = 0; i < count; i++) t->given.vertices[i] = t->plain.vertices[i];
    if (kind == TWICE) count = with_copies(source, &t->plain, t->given.vertices);
    random_renumber(source, t->given.vertices, count);
    random_bake(&t->given, count);
    oracle_read_polygon(&t->exact, &t->plain.polygon);
}

/* ---- circles ---- */

typedef struct circle_at { tuff_vec2 center; tuff_real radius; } circle_at;

/* From a vertex or a point of an edge: along its normal, on along the edge, or anywhere. */
static tuff_vec2 near_outline(random_source *source, const oracle_polygon *p, double away)
{
    int i = (int)random_below(source, (uint32_t)p->count), next = (i + 1) % p->count;
    double share = random_chance(source, 50) ? 0 : random_fraction(source), angle = random_within(source, 0, TURN);
    double x = (double)p->vertices[i].x, y = (double)p->vertices[i].y, nx = (double)p->normals[i].x, ny = (double)p->normals[i].y;
    x += ((double)p->vertices[next].x - x) * share;
    y += ((double)p->vertices[next].y - y) * share;
    switch (random_below(source, 3)) {
    case 0:  return vec2_from_doubles(x + nx * away, y + ny * away);
    case 1:  return vec2_from_doubles(x - ny * away, y + nx * away);
    default: return vec2_from_doubles(x + cos(angle) * away, y + sin(angle) * away);
    }
}

static circle_at place_circle(random_source *source, const thin *t, double size)
{
    double radius = random_magnitude(source, 1.0 / 64, size) * EXACT_UNIT, away = radius * random_within(source, -1.1, 1.1);
    if (random_chance(source, 30)) away = radius + family_steps(source);
    if (random_chance(source, 20)) away = family_steps(source);
    return (circle_at){ near_outline(source, &t->exact, away), real_from_double(radius) };
}

static exact circle_depth(const thin *t, tuff_vec2 at, tuff_real radius, oracle_answer *answer)
{
    oracle_circle(&t->exact, exact_vec2(at), exact_real(radius), answer);
    return answer->depth;
}

static void judge_circle(accuracy *sum, const random_run *run, uint32_t index, const thin *t, circle_at circle, double size)
{
    accuracy_bounds bounds = accuracy_bounds_of(size);
    oracle_answer answer, after;
    tuff_contact contact = accuracy_untouched;
    tuff_terrain piece = convex_piece(&t->given, (tuff_vec2){ 0, 0 });
    bool found = index % 2 == 0 ? tuff_circle_polygon(circle.center, circle.radius, &t->given.polygon, &contact)
                                : tuff_terrain_overlap_circle(&piece, circle.center, circle.radius, &contact);
    exact depth = circle_depth(t, circle.center, circle.radius, &answer);
    const char *fault = accuracy_judge(sum, &bounds, &answer, exact_abs(depth), found, &contact);
    tuff_vec2 pushed = accuracy_pushed(circle.center, &contact);
    if (found && !fault) fault = accuracy_judge_push(sum, &bounds, circle_depth(t, pushed, circle.radius, &after), pushed);
    accuracy_report_fault(sum, run, index, fault, &answer, found, &contact);
}

/* ---- hulls ---- */

/* A vertex of the one on the outline of the other, or the hull anywhere in reach. */
static tuff_vec2 place_hull(random_source *source, const thin *piece, const thin *hull, double size)
{
    if (random_chance(source, 30)) return random_point(source, 1.5 * size);
    double away = random_chance(source, 60) ? family_steps(source) : random_within(source, -0.2, 0.2) * size * EXACT_UNIT;
    tuff_vec2 on = near_outline(source, &piece->exact, away), own = hull->plain.vertices[random_below(source, hull->plain.polygon.count)];
    return (tuff_vec2){ on.x - own.x, on.y - own.y };
}

static exact hull_margin(const thin *piece, const thin *hull, tuff_vec2 offset, const oracle_answer *answer, bool found)
{
    if (!found || answer->depth > 0) return exact_abs(answer->depth);
    return oracle_hull_distance(&piece->exact, &hull->exact, exact_vec2(offset));
}

/* A hull beside a piece. */
typedef struct thin_pair { const thin *piece, *hull; tuff_vec2 offset; double size; } thin_pair;

static void judge_hull(accuracy *sum, const random_run *run, uint32_t index, const thin_pair *at)
{
    const thin *piece = at->piece, *hull = at->hull;
    tuff_vec2 offset = at->offset;
    accuracy_bounds bounds = accuracy_bounds_of(at->size);
    oracle_answer answer, after;
    tuff_contact contact = accuracy_untouched;
    tuff_polygon bare = hull->given.polygon;
    if (index % 2 == 1) bare.normals = NULL;
    bool found = tuff_polygon_polygon(&bare, offset, &piece->given.polygon, &contact);
    oracle_hull(&piece->exact, &hull->exact, exact_vec2(offset), &answer);
    const char *fault = accuracy_judge(sum, &bounds, &answer, hull_margin(piece, hull, offset, &answer, found), found, &contact);
    tuff_vec2 pushed = accuracy_pushed(offset, &contact);
    oracle_hull(&piece->exact, &hull->exact, exact_vec2(pushed), &after);
    if (found && !fault) fault = accuracy_judge_push(sum, &bounds, after.depth, pushed);
    accuracy_report_fault(sum, run, index, fault, &answer, found, &contact);
}

/* ---- accuracy of every kind ---- */

typedef void one_case(accuracy *sum, const random_run *run, uint32_t index, thin_kind kind, double size);

static void circle_case(accuracy *sum, const random_run *run, uint32_t index, thin_kind kind, double size)
{
    random_source source = random_stream(run->seed + (uint64_t)kind, index);
    static thin t;
    make_thin(&source, &t, kind, size);
    for (int i = 0; i < 8; i++) judge_circle(sum, run, index, &t, place_circle(&source, &t, size), size);
}

/* Against every kind. */
static void hull_case(accuracy *sum, const random_run *run, uint32_t index, thin_kind kind, double size)
{
    random_source source = random_stream(run->seed + (uint64_t)kind, index);
    static thin piece, hull;
    make_thin(&source, &hull, kind, size);
    make_thin(&source, &piece, (thin_kind)random_below(&source, KINDS), size);
    for (int i = 0; i < 4; i++) {
        thin_pair at = { &piece, &hull, place_hull(&source, &piece, &hull, size), size };
        judge_hull(sum, run, index, &at);
    }
}

/* Half of them to 64 units, half to 1024, where the float build's bounds are wider. */
static unsigned long run_kinds(const char *name, const char *what, uint64_t seed, uint32_t count, one_case *one)
{
    random_run run = random_cases(name, seed, count);
    unsigned long faults = 0;
    for (int kind = 0; kind < KINDS; kind++) {
        for (int large = kind == LARGE; large < 2; large++) {
            char title[96];
            accuracy sum = { 0 };
            for (uint32_t i = run.first; i < run.end; i++) one(&sum, &run, i, (thin_kind)kind, large ? 1023.0 : 64.0);
            snprintf(title, sizeof title, "%s, %s, to %d units", what, kind_names[kind], large ? 1024 : 64);
            accuracy_print(&sum, title);
            faults += sum.faults;
        }
    }
    return faults;
}

static void test_circles_meet_every_thin_obstacle_to_the_bounds_of_all_shapes(void **state)
{
    (void)state;
    assert_int_equal(run_kinds(__func__, "circle", 1401, 2000, circle_case), 0);
}

static void test_thin_hulls_meet_every_thin_obstacle_to_the_bounds_of_all_shapes(void **state)
{
    (void)state;
    assert_int_equal(run_kinds(__func__, "hull", 1402, 1500, hull_case), 0);
}

/* ---- segments ---- */

/* Through a vertex, ending short of it or behind it; along an edge; or anywhere. */
static void place_segment(random_source *source, const thin *t, double size, tuff_vec2 *a, tuff_vec2 *b)
{
    tuff_vec2 vertex = t->plain.vertices[random_below(source, t->plain.polygon.count)];
    int32_t x = random_between(source, -4096, 4096), y = random_between(source, -4096, 4096), near_end = random_between(source, -2, 4);
    *a = (tuff_vec2){ vertex.x + TUFF_REAL_RAW(64 * near_end * x), vertex.y + TUFF_REAL_RAW(64 * near_end * y) };
    *b = (tuff_vec2){ vertex.x + TUFF_REAL_RAW(64 * 5 * x), vertex.y + TUFF_REAL_RAW(64 * 5 * y) };
    if (random_chance(source, 50)) return;
    *a = near_outline(source, &t->exact, family_steps(source));
    *b = random_chance(source, 50) ? near_outline(source, &t->exact, family_steps(source)) : random_point(source, size);
}

static const char *segment_fault(const thin *t, tuff_vec2 a, tuff_vec2 b)
{
    exact2 from = exact_vec2(a), to = exact_vec2(b);
    bool truth = oracle_segment_polygon(&t->exact, from, to), found = tuff_segment_polygon(a, b, &t->given.polygon);
    if (found != tuff_segment_polygon(b, a, &t->given.polygon)) return "ends swapped, another answer";
    if (found == truth) return NULL;
    exact band = EXACT_WHOLE ? 0 : accuracy_float_beam_band(exact_length(exact_sub(to, from)));
    return oracle_segment_polygon_margin(&t->exact, from, to) > band ? "yes or no" : NULL;
}

static void segment_case(accuracy *sum, const random_run *run, uint32_t index, thin_kind kind, double size)
{
    random_source source = random_stream(run->seed + (uint64_t)kind, index);
    static thin t;
    make_thin(&source, &t, kind, size);
    for (int i = 0; i < 8; i++) {
        tuff_vec2 a, b;
        place_segment(&source, &t, size, &a, &b);
        const char *fault = segment_fault(&t, a, b);
        sum->pairs++;
        sum->wrong += fault != NULL;
        random_count_fault(&sum->faults, run, index, fault);
    }
}

static void test_segments_are_right_on_every_thin_obstacle(void **state)
{
    (void)state;
    assert_int_equal(run_kinds(__func__, "segment", 1403, 1500, segment_case), 0);
}

/* ---- the methods that fail, and Box2D, on the same shapes ---- */

static tuff_real real_part(double units)
{
    return real_from_double(units * EXACT_UNIT);
}

/* The sanitizers stop at 0 / 0. */
static double quotient(double a, double b)
{
    return b > 0 || b < 0 ? a / b : (double)NAN;
}

/* An edge divided by its length: in float 0 / 0 for an edge without length; in Q16.16 no direction for one whose square is lost
   in the product's shift. */
static tuff_vec2 careless_normal(tuff_vec2 edge, tuff_unit2 outward)
{
    double x = units_of(edge.x), y = units_of(edge.y), square = x * x + y * y;
    if (TUFF_SCALAR == TUFF_Q16_16) square = floor(x * x * EXACT_UNIT) / EXACT_UNIT + floor(y * y * EXACT_UNIT) / EXACT_UNIT;
    if (TUFF_SCALAR == TUFF_Q16_16 && square <= 0) return (tuff_vec2){ 0, 0 };
    double side = y * (double)exact_unit(outward.x) - x * (double)exact_unit(outward.y) < 0 ? -1 : 1, length = sqrt(square) * side;
    return (tuff_vec2){ real_part(quotient(y, length)), real_part(quotient(-x, length)) };
}

static void read_carelessly(naive_polygon *naive, const random_shape *shape)
{
    int count = shape->polygon.count;
    naive_read(naive, &shape->polygon);
    for (int i = 0; i < count; i++) {
        tuff_vec2 from = shape->vertices[i], to = shape->vertices[(i + 1) % count];
        naive->normals[i] = careless_normal((tuff_vec2){ to.x - from.x, to.y - from.y }, shape->normals[i]);
    }
}

/* A way out is as long as a unit vector, nearly; NaN is none. */
static bool is_way_out(double x, double y)
{
    return x * x + y * y > 0.9;
}

typedef struct figures { unsigned long asked, taken, wrong; double depth; } figures;

/* The depth that a method found (0: none) beside the truth. */
static void take(figures *of, exact truth, bool found, exact depth)
{
    const exact band = (exact)EXACT_UNIT / 1000;
    of->taken++;
    if (found != (truth > 0)) of->wrong += exact_abs(truth) > band;
    else if (found) raise_to(&of->depth, exact_abs(depth - truth));
}

/* Box2D makes one vertex of two nearer than half its slop; with fewer than three left it ends the program. */
static bool box2d_would_weld(const random_shape *shape)
{
    const double slop = 0.005 / 2 * EXACT_UNIT;
    for (int i = 0; i < shape->polygon.count; i++) {
        for (int k = 0; k < i; k++) {
            if (exact_length(exact_sub(exact_vec2(shape->vertices[i]), exact_vec2(shape->vertices[k]))) < (exact)slop) return true;
        }
    }
    return false;
}

static void take_box2d(figures *of, const thin *t, circle_at circle, exact truth)
{
    box2d_contact contact = { 0, { 0, 0 } };
    of->asked++;
    if (t->given.polygon.count > YARDSTICK_VERTICES || box2d_would_weld(&t->given)) return;
    box2d_polygon *polygon = box2d_of(&t->given.polygon);
    if (polygon == NULL) return;
    bool found = box2d_circle_polygon(polygon, (box2d_vec){ 0, 0 }, twin_vec(circle.center), tuff_to_float(circle.radius), &contact);
    take(of, truth, found && contact.overlap > 0, (exact)contact.overlap * EXACT_UNIT);
    box2d_polygon_free(polygon);
}

typedef struct versus { figures naive, box2d, tuff; unsigned long careless, overlaps, no_push; } versus;

static void versus_case(versus *sum, random_source *source, const thin *t, double size)
{
    circle_at circle = place_circle(source, t, size);
    oracle_answer answer;
    exact truth = circle_depth(t, circle.center, circle.radius, &answer);
    textbook_contact rough, careless;
    tuff_contact contact;
    naive_polygon naive;
    naive_read(&naive, &t->given.polygon);
    bool found = textbook_circle(circle.center, circle.radius, &naive.polygon, &rough);
    take(&sum->naive, truth, found, found ? exact_real(rough.overlap) : 0);
    take_box2d(&sum->box2d, t, circle, truth);
    bool ours = tuff_circle_polygon(circle.center, circle.radius, &t->given.polygon, &contact);
    take(&sum->tuff, truth, ours, ours ? exact_real(contact.overlap) : 0);
    if (truth <= EXACT_UNIT / 1000) return;
    read_carelessly(&naive, &t->given);
    sum->overlaps++;
    found = textbook_circle(circle.center, circle.radius, &naive.polygon, &careless);
    sum->careless += !found || !is_way_out(units_of(careless.normal.x), units_of(careless.normal.y));
    sum->no_push += !ours || !is_way_out((double)exact_unit(contact.normal.x), (double)exact_unit(contact.normal.y));
}

static versus compare_kind(const char *name, uint64_t seed, thin_kind kind, double size)
{
    random_run run = random_cases(name, seed, 8000);
    static thin t;
    versus sum = { { 0 }, { 0 }, { 0 }, 0, 0, 0 };
    for (uint32_t i = run.first; i < run.end; i++) {
        random_source source = random_stream(run.seed, i);
        make_thin(&source, &t, kind, size);
        versus_case(&sum, &source, &t, size);
    }
    return sum;
}

static void test_careless_normals_find_no_way_out_where_a_vertex_is_given_twice(void **state)
{
    (void)state;
    versus sum = compare_kind(__func__, 1404, TWICE, 64);
    table_row("a vertex twice: overlaps without a push, %");
    table_fails("normal = edge / length", "%.1f", percent(sum.careless, sum.overlaps));
    table_box2d("refuses %.0f %%", 100 - percent(sum.box2d.taken, sum.box2d.asked));
    table_tuff("%.1f", percent(sum.no_push, sum.overlaps));
    assert_true(sum.careless > 0);
    assert_int_equal(sum.no_push, 0);
    assert_int_equal(sum.tuff.wrong, 0);
}

/* Of the largest rocks and of needles as long: 16 bits of normal are a 65,536th of a vertex's distance, and there are two such
   errors. */
static void test_coarse_normals_err_by_hundredths_of_a_unit_on_needles_of_1024(void **state)
{
    (void)state;
    versus sum = compare_kind(__func__, 1405, NEEDLE, 1023);
    const double held = TUFF_SCALAR == TUFF_Q16_16 ? 1 : EXACT_UNIT / 1000.0;
    table_row("needles 1:1000 of 1024 units: largest depth error, units");
    table_fails("textbook", "%.1e", sum.naive.depth / EXACT_UNIT);
    table_box2d("%.1e", sum.box2d.depth / EXACT_UNIT);
    table_tuff("%.1e", sum.tuff.depth / EXACT_UNIT);
    printf("figures: needles: Box2D takes %lu of %lu\n", sum.box2d.taken, sum.box2d.asked);
    assert_true(sum.naive.depth > EXACT_UNIT / 100.0);
    assert_true(sum.tuff.depth <= held);
}

/* The textbook asks each edge; one without length lies on every line through it, also on that of a beam that ends before. */
static void test_beams_that_end_short_of_a_doubled_vertex_do_not_hit(void **state)
{
    random_run run = random_cases(__func__, 1406, 8000);
    unsigned long free_beams = 0, naive_hits = 0, hits = 0;
    static thin t;
    (void)state;
    for (uint32_t i = run.first; i < run.end; i++) {
        random_source source = random_stream(run.seed, i);
        naive_polygon naive;
        tuff_vec2 a, b;
        make_thin(&source, &t, TWICE, 64);
        place_segment(&source, &t, 64, &a, &b);
        exact margin = oracle_segment_polygon_margin(&t.exact, exact_vec2(a), exact_vec2(b));
        if (oracle_segment_polygon(&t.exact, exact_vec2(a), exact_vec2(b)) || margin < EXACT_UNIT / 100) continue;
        naive_read(&naive, &t.given.polygon);
        free_beams++;
        naive_hits += textbook_segment(a, b, &naive.polygon);
        hits += tuff_segment_polygon(a, b, &t.given.polygon);
    }
    table_row("a vertex twice: free beams told as hits, %");
    table_fails("textbook", "%.1f", percent(naive_hits, free_beams));
    table_tuff("%.1f", percent(hits, free_beams));
    assert_true(naive_hits > 0);
    assert_int_equal(hits, 0);
}

/* ---- with the checks on ---- */

/* By every call that looks at the shape. */
static void expect_named(tuff_fault wanted, const random_shape *shape)
{
    tuff_terrain piece = convex_piece(shape, (tuff_vec2){ 0, 0 });
    tuff_world world = plain_world(&piece, 1, TUFF_ORDER_ITERATION);
    tuff_body body = body_at((tuff_vec2){ 0, 0 });
    assert_int_equal(tuff_check_polygon(&shape->polygon), wanted);
    assert_int_equal(tuff_check_hull(&shape->polygon), wanted);
    assert_int_equal(tuff_check_terrain(&piece), wanted);
    assert_int_equal(tuff_check_body(&body, shape->bounding_radius, &shape->polygon), wanted);
    assert_int_equal(tuff_check_world(&world, NULL), wanted);
}

static void test_the_checks_take_what_is_thin_and_name_what_is_degenerate(void **state)
{
    random_run run = random_cases(__func__, 1407, 100);
    static thin t;
    (void)state;
    for (uint32_t i = run.first; i < run.end; i++) {
        for (int kind = 0; kind < KINDS; kind++) {
            random_source source = random_stream(run.seed + (uint64_t)kind, i);
            make_thin(&source, &t, (thin_kind)kind, kind == LARGE ? 1023 : 64);
            if (kind == SLIVER && TUFF_SCALAR == TUFF_FLOAT) continue;
            expect_named(kind == TWICE ? TUFF_FAULT_DUPLICATE_VERTEX : TUFF_OK, &t.given);
        }
    }
}

/* In float a turn of less than its rounding has no sign: the check may take it for straight on, or for the wrong way. */
static void test_the_checks_of_float_name_slivers_or_take_them(void **state)
{
    random_run run = random_cases(__func__, 1408, 8000);
    unsigned long named[TUFF_FAULT_COUNT] = { 0 };
    static thin t;
    (void)state;
    for (uint32_t i = run.first; i < run.end; i++) {
        random_source source = random_stream(run.seed, i);
        make_thin(&source, &t, SLIVER, 64);
        named[tuff_check_polygon(&t.given.polygon)]++;
    }
    printf("figures: triangles of 1 LSB and less, " EXACT_BUILD ": %lu taken, %lu without area, %lu concave, of %lu\n", named[TUFF_OK],
           named[TUFF_FAULT_NO_AREA], named[TUFF_FAULT_CONCAVE], (unsigned long)(run.end - run.first));
    assert_int_equal(named[TUFF_OK] + named[TUFF_FAULT_NO_AREA] + named[TUFF_FAULT_CONCAVE], run.end - run.first);
    if (EXACT_WHOLE) assert_int_equal(named[TUFF_OK], run.end - run.first);
}

static void test_shapes_without_area_or_beyond_the_limits_are_named(void **state)
{
    random_shape shape;
    (void)state;
    for (int i = 0; i < 3; i++) shape.vertices[i] = (tuff_vec2){ TUFF_WHOLE(8 * i), TUFF_WHOLE(4 * i) };
    random_bake(&shape, 3);
    expect_named(TUFF_FAULT_NO_AREA, &shape);
    shape.polygon.count = 2;
    expect_named(TUFF_FAULT_TOO_FEW_VERTICES, &shape);
    shape.polygon.count = TUFF_MAX_VERTICES + 1;
    expect_named(TUFF_FAULT_TOO_MANY_VERTICES, &shape);
    random_box_shape(&shape, (tuff_vec2){ TUFF_WHOLE(TUFF_MAX_EXTENT), TUFF_WHOLE(TUFF_MAX_EXTENT) });
    expect_named(TUFF_OK, &shape);
    random_box_shape(&shape, (tuff_vec2){ TUFF_WHOLE(TUFF_MAX_EXTENT) + TUFF_REAL_RAW(64), TUFF_WHOLE(1) });
    expect_named(TUFF_FAULT_VERTEX_RANGE, &shape);
}

/* ---- what is left: shapes without area ---- */

/* A triangle whose vertices lie in one line is that line, for circles and hulls. */
static void test_a_polygon_in_one_line_is_a_wall_without_thickness(void **state)
{
    const tuff_real ends[4] = { TUFF_WHOLE(-20), TUFF_WHOLE(-16), TUFF_WHOLE(16), TUFF_WHOLE(20) };
    random_shape line, hull;
    (void)state;
    for (int i = 0; i < 3; i++) line.vertices[i] = (tuff_vec2){ TUFF_WHOLE(16 * i - 16), 0 };
    random_bake(&line, 3);
    random_box_shape(&hull, (tuff_vec2){ TUFF_WHOLE(4), TUFF_WHOLE(4) });
    for (int i = 0; i < 4; i++) {
        for (int side = -1; side <= 1; side += 2) {
            tuff_contact contact;
            tuff_vec2 at = { ends[i] + (side < 0 ? TUFF_REAL_RAW(64) : -TUFF_REAL_RAW(64)), TUFF_WHOLE(3 * side) };
            bool over = at.x > TUFF_WHOLE(-16) && at.x < TUFF_WHOLE(16), reached = at.x > TUFF_WHOLE(-20) && at.x < TUFF_WHOLE(20);
            assert_int_equal(tuff_circle_polygon(at, TUFF_RATIO(7, 2), &line.polygon, &contact), over || i == 1 || i == 2);
            assert_int_equal(tuff_polygon_polygon(&hull.polygon, at, &line.polygon, &contact), reached);
        }
    }
    assert_true(tuff_segment_polygon((tuff_vec2){ ends[1], ends[0] }, (tuff_vec2){ ends[1], ends[3] }, &line.polygon));
    assert_false(tuff_segment_polygon((tuff_vec2){ ends[0], ends[0] }, (tuff_vec2){ ends[0], ends[3] }, &line.polygon));
    /* What is left: along the line the wall has no end. */
    assert_true(tuff_segment_polygon((tuff_vec2){ ends[3], 0 }, (tuff_vec2){ 2 * ends[3], 0 }, &line.polygon));
}

/* With all vertices in one point there is no face: the normals are (1, 0), and what lies to its left counts as inside. Largest
   error of depth over a circle of 8 units about a point 4 units off its owner's position, through the call that asks the
   bounding circles first.
 */
static void test_a_polygon_in_one_point_errs_by_no_more_than_the_bounding_circle(void **state)
{
    random_shape point;
    double most = 0;
    (void)state;
    for (int i = 0; i < 3; i++) point.vertices[i] = (tuff_vec2){ TUFF_WHOLE(4), 0 };
    random_bake(&point, 3);
    tuff_terrain piece = convex_piece(&point, (tuff_vec2){ 0, 0 });
    for (int32_t i = 0; i < 64 * 64; i++) {
        tuff_contact contact = accuracy_untouched;
        tuff_vec2 at = { TUFF_RATIO(i % 64 - 32, 2), TUFF_RATIO(i / 64 - 32, 2) };
        exact truth = (exact)(8 * EXACT_UNIT) - exact_length(exact_sub(exact_vec2(at), exact_vec2(point.vertices[0])));
        bool found = tuff_terrain_overlap_circle(&piece, at, TUFF_WHOLE(8), &contact);
        raise_to(&most, exact_abs((found ? exact_real(contact.overlap) : 0) - (truth > 0 ? truth : 0)));
    }
    printf("figures: all vertices in one point, " EXACT_BUILD ": largest error of depth %.1f units\n", most / EXACT_UNIT);
    assert_true(most <= 2.0 * (8 + 4) * EXACT_UNIT);    /* both radii, from the one side to the other */
}

/* ---- the picture ---- */

static void draw_push(picture_role role, tuff_vec2 at, double x, double y, double overlap)
{
    double from_x = units_of(at.x), from_y = units_of(at.y);
    picture_dot(role, from_x, from_y);
    if (is_way_out(x, y)) picture_arrow(role, from_x, from_y, from_x + x * overlap, from_y + y * overlap);
}

/* A circle deep in a rock whose upper right corner is given twice. */
static void draw_doubled_corner(void)
{
    static const int8_t corners[7][2] = { { -20, -12 }, { 4, -16 }, { 18, -10 }, { 22, 12 }, { 22, 12 }, { 0, 18 }, { -22, 10 } };
    const tuff_vec2 at = { TUFF_WHOLE(6), TUFF_WHOLE(9) };
    random_shape rock;
    naive_polygon naive;
    textbook_contact careless = { 0, { 0, 0 } };
    tuff_contact contact = accuracy_untouched;
    for (int i = 0; i < 7; i++) rock.vertices[i] = (tuff_vec2){ TUFF_WHOLE(corners[i][0]), TUFF_WHOLE(corners[i][1]) };
    random_bake(&rock, 7);
    read_carelessly(&naive, &rock);
    (void)textbook_circle(at, TUFF_WHOLE(4), &naive.polygon, &careless);
    (void)tuff_circle_polygon(at, TUFF_WHOLE(4), &rock.polygon, &contact);
    picture_panel("A corner given twice: the way out", -28, -22, 30, 26);
    picture_polygon(PICTURE_ROCK, &rock.polygon, (tuff_vec2){ 0, 0 });
    picture_circle(PICTURE_BODY, at, TUFF_WHOLE(4));
    draw_push(PICTURE_TUFF, at, (double)exact_unit(contact.normal.x), (double)exact_unit(contact.normal.y), units_of(contact.overlap));
    draw_push(PICTURE_FAILS, at, units_of(careless.normal.x), units_of(careless.normal.y), units_of(careless.overlap));
    picture_note(17.5, 15.5, "two vertices");
    picture_note(-18, 2, "edge / length finds (0, 0)");
}

/* Needles 1:1000 of several lengths. */
static void draw_needle_errors(int which)
{
    for (double size = 8; size <= 1024; size *= 2) {
        static thin t;
        versus sum = { { 0 }, { 0 }, { 0 }, 0, 0, 0 };
        for (uint32_t i = 0; i < 1500; i++) {
            random_source source = random_stream(1410, i);
            make_thin(&source, &t, NEEDLE, size - 1.0 / 64);
            versus_case(&sum, &source, &t, size);
        }
        picture_point(size, (which == 0 ? sum.naive.depth : which == 1 ? sum.box2d.depth : sum.tuff.depth) / EXACT_UNIT);
    }
}

static void draw_picture(void)
{
    static const picture_role roles[3] = { PICTURE_FAILS, PICTURE_BOX2D, PICTURE_TUFF };
    if (!picture_begin("thin")) return;
    draw_doubled_corner();
    picture_chart("Circles on needles 1:1000: depth error", "half length, units", "log", "largest error, units", "log");
    for (int i = 0; i < 3; i++) {
        picture_line(roles[i], "");
        draw_needle_errors(i);
        picture_line_end();
    }
    picture_end();
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_circles_meet_every_thin_obstacle_to_the_bounds_of_all_shapes),
        cmocka_unit_test(test_thin_hulls_meet_every_thin_obstacle_to_the_bounds_of_all_shapes),
        cmocka_unit_test(test_segments_are_right_on_every_thin_obstacle),
        cmocka_unit_test(test_careless_normals_find_no_way_out_where_a_vertex_is_given_twice),
        cmocka_unit_test(test_coarse_normals_err_by_hundredths_of_a_unit_on_needles_of_1024),
        cmocka_unit_test(test_beams_that_end_short_of_a_doubled_vertex_do_not_hit),
        cmocka_unit_test(test_the_checks_take_what_is_thin_and_name_what_is_degenerate),
        cmocka_unit_test(test_the_checks_of_float_name_slivers_or_take_them),
        cmocka_unit_test(test_shapes_without_area_or_beyond_the_limits_are_named),
        cmocka_unit_test(test_a_polygon_in_one_line_is_a_wall_without_thickness),
        cmocka_unit_test(test_a_polygon_in_one_point_errs_by_no_more_than_the_bounding_circle),
    };
    (void)argc;
    random_begin(argv);
    table_family(4, "Thin and degenerate shapes");
    draw_picture();
    return cmocka_run_group_tests(tests, NULL, NULL);
}
