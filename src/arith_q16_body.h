/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Square roots, directions, the bounce and the beam's fractions in integers. Only arith.c includes this. No floating
   point, and no division but in the three functions of a beam's first hit. */

/* Without a branch. */
static inline uint32_t tuff_size32(int32_t a)
{
    uint32_t sign = 0u - ((uint32_t)a >> 31);
    return ((uint32_t)a ^ sign) - sign;
}

/* Leading pairs of zero bits, of a > 0. A compare and two conditional instructions a step where there is no instruction for
   it (ARM7, Cortex-M0). */
static unsigned tuff_leading_pairs(uint32_t a)
{
    unsigned pairs = 0;
    if (a >> 16 == 0) {
        a <<= 16;
        pairs = 8;
    }
    if (a >> 24 == 0) {
        a <<= 8;
        pairs += 4;
    }
    if (a >> 28 == 0) {
        a <<= 4;
        pairs += 2;
    }
    return pairs + (a >> 30 == 0 ? 1 : 0);
}

/* 1 / sqrt(q / 2^64) in Q1.31 for q in [2^62, 2^64), to 2^32 - 1 where it is 2. Relative error below 0.6 * 2^-31.

   With u = q / 2^64 in [1/4, 1):
     1. a cubic (minimax; coefficients in Q19.13) gives y0 within 0.0071, relatively; its rounding adds 0.0005;
     2. one Newton step y1 = y0 (3 - u y0^2) / 2 squares that: 3/2 * 0.0076^2 < 8.7e-5, plus 2^-15 for the 16 bits of u
        that it reads (half of 2^-16 / (1/4)) and 2^-16 for its roundings: below 1.6e-4;
     3. the residue e = 1 - u y1^2, from all 64 bits of q, is then below 3.2e-4 and exact to 2^-41, and 1 / sqrt(u) =
        y1 (1 - e)^(-1/2) = y1 (1 + e/2 + 3/8 e^2 + 5/16 e^3 + ...), of which the terms left out are below 1.1e-11;
     4. that and the two roundings of the series are below 0.05 * 2^-31, the rounding to Q1.31 is 0.5 * 2^-31.

   A component of a direction is a length below 2^32 times this: 0.3 * 2^-30, and 0.5 * 2^-30 for its own rounding. */
static uint32_t tuff_inverse_root(uint64_t q)
{
    uint32_t u = (uint32_t)(q >> 32);
    int32_t u16 = (int32_t)(u >> 16);
    int32_t seed = 51036 - ((19976 * u16) >> 16);
    seed = -48422 + ((seed * u16) >> 16);
    seed = 25497 + ((seed * u16) >> 16);

    uint32_t y0 = (uint32_t)seed;                                          /* Q13, 1 .. 2.02 */
    uint32_t uyy = ((y0 * y0) >> 11) * (uint32_t)u16;                      /* Q31, about 1 */
    uint32_t y1 = (y0 * ((((uint32_t)3 << 30) - (uyy >> 1)) >> 14)) >> 14; /* Q16 */

    uint64_t uy = (uint64_t)u * y1 + ((uint64_t)(uint32_t)q * y1 >> 32);   /* Q48 */
    int64_t residue = ((int64_t)1 << 61) - (int64_t)((uy >> 3) * y1);      /* Q61 */
    int32_t e = (int32_t)(residue >> 20);                                  /* Q41, below 2^30 */
    int32_t series = (e >> 1) + ((3 * (int32_t)(((int64_t)e * e) >> 41)) >> 3);
    uint32_t y = (y1 << 15) + (uint32_t)(((int64_t)series * (int32_t)y1 + ((int32_t)1 << 25)) >> 26);
    return y < (uint32_t)1 << 30 ? TUFF_UINT32_MAX : y;     /* 2^32 wraps to little */
}

/* size * 2^shift < 2^32 and inverse / 2^31 = 2^(32 - shift) / length give size / length in Q2.30. On an axis it is within
   0.3 * 2^-30 of 1 before it is rounded: 1. */
static tuff_unit tuff_component(int32_t component, uint32_t shifted_size, uint32_t inverse)
{
    int32_t unit = (int32_t)(((uint32_t)((uint64_t)shifted_size * inverse >> 32) + 1) >> 1);
    return component < 0 ? -unit : unit;
}

/* The integer closest to sqrt(square), where q = square * 4^shift is in [2^62, 2^64), u its high word and inverse =
   tuff_inverse_root(q). u * inverse is sqrt(q) / 2 less at most 2.5 for what is cut off, or more by at most 0.6: less 1,
   it is not above, and n goes up to where n^2 - n < square <= n^2 + n. */
static uint32_t tuff_root_from(uint64_t square, unsigned shift, uint32_t u, uint32_t inverse)
{
    uint32_t n = (((uint32_t)((uint64_t)u * inverse >> 32) - 1) << 1) >> shift;
    int64_t gap = (int64_t)(square - (uint64_t)n * n);
    while (gap > n) {
        gap -= (int64_t)n + n + 1;
        ++n;
    }
    return n;
}

tuff_real tuff_normalize_xy(tuff_real x, tuff_real y, tuff_unit2 *direction)
{
    const uint64_t square = (uint64_t)((int64_t)x * x) + (uint64_t)((int64_t)y * y);
    if (square == 0) return 0;
    const uint32_t high = (uint32_t)(square >> 32);
    const unsigned shift = tuff_leading_pairs(high != 0 ? high : (uint32_t)square) + (high != 0 ? 0 : 16);
    const uint64_t q = square << (2 * shift);
    const uint32_t inverse = tuff_inverse_root(q);
    direction->x = tuff_component(x, tuff_size32(x) << shift, inverse);
    direction->y = tuff_component(y, tuff_size32(y) << shift, inverse);
    const uint32_t length = tuff_root_from(square, shift, (uint32_t)(q >> 32), inverse);
    return length > TUFF_INT32_MAX ? TUFF_INT32_MAX : (tuff_real)length;
}

/* The odd edges first: it is asked where the point is surely beyond none of the even ones. Most edges are less than the best so far,
   which takes one compare. */
TUFF_HOT uint32_t tuff_farthest_edge(const tuff_polygon *polygon, const tuff_vec2 *point, tuff_wide *separation)
{
    const tuff_vec2 center = *point;
    const tuff_vec2 *const end = polygon->vertices + polygon->count;
    const tuff_vec2 *farthest = polygon->vertices;
    tuff_wide most = TUFF_WIDE_LOWEST;
    uint32_t first = 2;
    do {
        --first;
        const tuff_vec2 *v = polygon->vertices + first;
        const tuff_unit2 *n = polygon->normals + first;
        do {
            tuff_wide beyond = tuff_project(*n, tuff_vec2_sub(center, *v));
            if (beyond >= most && (beyond > most || v < farthest)) {
                most = beyond;
                farthest = v;
                if (tuff_roughly(beyond) > 0) break;
            }
            v += 2;
            n += 2;
        } while (v < end);
    } while (first != 0 && tuff_roughly(most) <= 0);
    *separation = most;
    return (uint32_t)(farthest - polygon->vertices);
}

/* keep * v - change * n, from Q32 and Q50 toward zero, within the speed limit. */
static tuff_real tuff_reflected(int32_t v, tuff_unit n, int32_t keep, int64_t change)
{
    const unsigned bits = 50 - TUFF_REAL_BITS;
    int64_t a = (int64_t)((uint64_t)((int64_t)keep * v * ((int64_t)1 << 18)) - (uint64_t)change * (uint64_t)(int64_t)n);
    return tuff_clamp64(a < 0 ? -(-a >> bits) : a >> bits, (int32_t)TUFF_MAX_SPEED << TUFF_REAL_BITS);
}

/* Formats: v . n in Q46, |v . n| < 1449 units; k (v . n) with k <= 5 in Q20, below 2^33; that times n in Q50, below 2^63;
   (1 - friction) v in Q32, below 2^42, shifted to Q50. Their difference is at most (e + 2) * 1449 units < 2^63 / 2^50. */
void tuff_reflect(tuff_vec2 *v, tuff_unit2 n, tuff_real restitution, tuff_real friction)
{
    int32_t limit = (int32_t)TUFF_MAX_SPEED << TUFF_REAL_BITS;
    int32_t vx = tuff_clamp64(v->x, limit);
    int32_t vy = tuff_clamp64(v->y, limit);
    int64_t inward = tuff_dot32(vx, vy, n.x, n.y);
    if (inward >= 0) return;
    int32_t keep = ((int32_t)1 << TUFF_REAL_BITS) - friction;
    /* Q46 * Q16 has more than 64 bits: the high 46 - 30 bits first. All is of one sign, so this rounds toward zero as well. */
    int64_t change = -(((((-inward) >> 16) * (keep + restitution)) >> 26));
    v->x = tuff_reflected(vx, n.x, keep, change);
    v->y = tuff_reflected(vy, n.y, keep, change);
}

/* --- beams ------------------------------------------------------------------------------------------------- */

static uint64_t tuff_size64(int64_t a)
{
    return a < 0 ? 0u - (uint64_t)a : (uint64_t)a;
}

/* Exact where it is within 2^61 - 2^51, else +-TUFF_FAR_HUGE. High and low words of b: |high| < 2^18, so
   that the sum of the high products has at most 53 bits, that of the low ones at most 51. */
tuff_area tuff_far_dot(const tuff_far2 *a, const tuff_far2 *b)
{
    int64_t high = a->x * (b->x >> 16) + a->y * (b->y >> 16);
    int64_t low = a->x * (b->x & 0xFFFF) + a->y * (b->y & 0xFFFF);
    if (high > (int64_t)1 << 45) return TUFF_FAR_HUGE;
    if (high < -((int64_t)1 << 45)) return -TUFF_FAR_HUGE;
    return high * 65536 + low;
}

tuff_area tuff_far_cross(const tuff_far2 *a, const tuff_far2 *b)
{
    const tuff_far2 turned = { -a->y, a->x };
    return tuff_far_dot(&turned, b);
}

bool tuff_turns_forward(const tuff_polygon *polygon)
{
    uint8_t i;
    for (i = 0; i < polygon->count; ++i) {
        tuff_vec2 right = tuff_right_of(polygon->vertices[i], polygon->vertices[i + 1 == polygon->count ? 0 : i + 1]);
        tuff_wide facing = tuff_project(polygon->normals[i], right);
        if (facing != 0) return facing > 0;
    }
    return true;
}

tuff_area tuff_edge_outside(const tuff_polygon *polygon, uint8_t i, bool forward, const tuff_far2 *p)
{
    tuff_vec2 from = polygon->vertices[i];
    tuff_vec2 to = polygon->vertices[i + 1 == polygon->count ? 0 : i + 1];
    int64_t ex = (int64_t)to.x - from.x;
    int64_t ey = (int64_t)to.y - from.y;
    uint64_t right = (uint64_t)ey * (uint64_t)(p->x - from.x) - (uint64_t)ex * (uint64_t)(p->y - from.y);
    return (int64_t)(forward ? right : 0u - right);
}

typedef struct tuff_u128 { uint64_t high, low; } tuff_u128;

/* The sum is known to fit. */
static void tuff_add_product(tuff_u128 *sum, uint64_t a, uint64_t b)
{
    uint64_t ah = a >> 32, al = a & 0xFFFFFFFFu;
    uint64_t bh = b >> 32, bl = b & 0xFFFFFFFFu;
    uint64_t low = al * bl;
    uint64_t middle = ah * bl + (low >> 32);
    uint64_t other = al * bh + (middle & 0xFFFFFFFFu);
    low = (other << 32) | (low & 0xFFFFFFFFu);
    sum->low += low;
    sum->high += ah * bh + (middle >> 32) + (other >> 32) + (sum->low < low ? 1 : 0);
}

static bool tuff_less128(const tuff_u128 *a, const tuff_u128 *b)
{
    return a->high < b->high || (a->high == b->high && a->low < b->low);
}

/* across^2 <= (radius d.x)^2 + (radius d.y)^2: the right side has at most 2 * (27 + 33) + 1 bits. */
bool tuff_chord_reaches(tuff_area across, const tuff_far2 *d, tuff_real radius)
{
    const uint64_t size = tuff_size64(across);
    const uint64_t x = tuff_size64(d->x) * (uint32_t)radius;
    const uint64_t y = tuff_size64(d->y) * (uint32_t)radius;
    tuff_u128 left = { 0, 0 }, right = { 0, 0 };
    tuff_add_product(&left, size, size);
    tuff_add_product(&right, x, x);
    tuff_add_product(&right, y, y);
    return !tuff_less128(&right, &left);
}

bool tuff_ratio_less(const tuff_ratio_of *a, const tuff_ratio_of *b)
{
    tuff_u128 left = { 0, 0 }, right = { 0, 0 };
    tuff_add_product(&left, (uint64_t)a->part, (uint64_t)b->whole);
    tuff_add_product(&right, (uint64_t)b->part, (uint64_t)a->whole);
    return tuff_less128(&left, &right);
}

/* Bits beyond the 32 highest of the denominator do not reach the result. */
tuff_unit tuff_ratio(tuff_area numerator, tuff_area denominator)
{
    while (denominator >> 32 != 0) {
        numerator >>= 1;
        denominator >>= 1;
    }
    return (tuff_unit)(((numerator << (TUFF_UNIT_BITS + 1)) / denominator + 1) >> 1);
}

/* The integer closest to sqrt(square), bit by bit: for a circle's entry only, which is rare. */
static uint32_t tuff_root(uint64_t square)
{
    uint64_t root = 0;
    uint64_t bit;
    for (bit = (uint64_t)1 << 62; bit != 0; bit >>= 2) {
        uint64_t step = root + bit;
        root >>= 1;
        if (square >= step) {
            square -= step;
            root += bit;
        }
    }
    return (uint32_t)root + (square > root ? 1 : 0);
}

/* A vector of 33-bit components with components up to 2^30, so that its length fits too: divided by 4 where it is longer, which is
   answered. */
static int32_t tuff_far_reduce(const tuff_far2 *d, tuff_vec2 *reduced)
{
    const uint32_t limit = (uint32_t)1 << 30;
    bool fits = tuff_far_narrow(*d, reduced);
    if (fits && (uint32_t)reduced->x + limit <= 2 * limit && (uint32_t)reduced->y + limit <= 2 * limit) return 1;
    reduced->x = (int32_t)(d->x / 4);
    reduced->y = (int32_t)(d->y / 4);
    return 4;
}

tuff_unit2 tuff_far_direction(const tuff_far2 *d)
{
    tuff_vec2 reduced;
    tuff_unit2 direction = { TUFF_UNIT_ONE, 0 };
    (void)tuff_far_reduce(d, &reduced);
    (void)tuff_normalize(reduced, &direction);
    return direction;
}

/* a . u in Q21, 5 bits below the LSB, for |a| <= 2^32.5 and a unit vector: below 2^63 in Q46. */
static int64_t tuff_far_project(const tuff_far2 *a, tuff_unit x, tuff_unit y)
{
    return tuff_shift_nearest(a->x * x + a->y * y, 25);
}

/* The foot of the center lies -a . u along the line and a x u beside it; the circle is entered sqrt(radius^2 -
   beside^2) earlier. All three lengths in Q21: radius < 2^31.5 / 2^21, so the squares fit 64 bits. */
tuff_unit tuff_circle_entry(const tuff_far2 *a, const tuff_far2 *d, tuff_real radius)
{
    tuff_vec2 reduced;
    tuff_unit2 u = { TUFF_UNIT_ONE, 0 };
    int32_t reduction = tuff_far_reduce(d, &reduced);
    int64_t length = (int64_t)tuff_normalize(reduced, &u) * (32 * reduction);
    uint64_t beside = tuff_size64(tuff_far_project(a, u.y, -u.x));
    uint64_t reach = (uint64_t)radius * 32;
    int64_t chord = beside < reach ? (int64_t)tuff_root(reach * reach - beside * beside) : 0;
    int64_t entry = tuff_far_project(a, -u.x, -u.y) - chord;
    return tuff_ratio(entry < 0 ? 0 : entry > length ? length : entry, length);
}

static tuff_real tuff_step_along(tuff_far from, tuff_far way, tuff_unit fraction)
{
    return (tuff_real)(from + tuff_shift_nearest(way * fraction, TUFF_UNIT_BITS));
}

tuff_vec2 tuff_along(const tuff_far2 *a, const tuff_far2 *d, tuff_unit fraction)
{
    tuff_vec2 point = { tuff_step_along(a->x, d->x, fraction), tuff_step_along(a->y, d->y, fraction) };
    return point;
}

/* --- segment against polygon, where 32 bits hold both ends --------------------------------------------------- */

/* Ends within 2^29 steps, 8,192 units. Then d has 31 bits, and all products below are within 2^61 with vertices in range,
   within 2^63 with any. */
#define TUFF_NEAR_BITS 29

static inline bool tuff_is_near(const tuff_vec2 *a, const tuff_vec2 *b)
{
    const uint32_t half = (uint32_t)1 << TUFF_NEAR_BITS;
    uint32_t all = ((uint32_t)a->x + half) | ((uint32_t)a->y + half) | ((uint32_t)b->x + half) | ((uint32_t)b->y + half);
    return all >> (TUFF_NEAR_BITS + 1) == 0;
}

typedef struct tuff_edge { const tuff_vec2 *from, *to; } tuff_edge;

/* edge x (p - from) */
static inline int64_t tuff_side_of(const tuff_edge *edge, const tuff_vec2 *p)
{
    return tuff_cross(tuff_vec2_sub(*edge->to, *edge->from), tuff_vec2_sub(*p, *edge->from));
}

/* Is p, a point of a line, before both edges? Along the line its side of the one falls and its side of the other rises. */
static inline unsigned tuff_before_both(const tuff_edge *falls, const tuff_edge *rises, const tuff_vec2 *p)
{
    return (unsigned)(tuff_side_of(falls, p) > 0) & (unsigned)(tuff_side_of(rises, p) < 0);
}

/* The two edges that cross a line, in the order of their vertices. */
typedef struct tuff_crossings {
    tuff_edge earlier, later;
    bool      up_first;      /* the earlier one leads up to d x v >= limit, the later one down from it */
} tuff_crossings;

/* Misses: no edge crosses, and no vertex is at d x v >= limit; unsure: all are. back: -d.y, so that d x v is a sum.
   start_side: d x v - limit of the first vertex. The loop is what a call costs: the sign of the high word is the side, and nothing
   branches on it, since a wrong guess costs a fast CPU more than a vertex does. */
static inline tuff_verdict tuff_find_crossings(const tuff_polygon *polygon, int32_t dx, int32_t back, int64_t limit, int64_t start_side,
                                               tuff_crossings *at)
{
    const tuff_vec2 *const vertices = polygon->vertices;
    const int32_t last = polygon->count - 1;
    int32_t side = (int32_t)(start_side >> 32);
    int32_t one = -1;
    int32_t other = last;
    int32_t i;
    for (i = 0; i < last; ++i) {
        int32_t next = (int32_t)((tuff_dot32(dx, back, vertices[i + 1].y, vertices[i + 1].x) - limit) >> 32);
        int32_t crosses = (next ^ side) >> 31;      /* all bits or none */
        one += (other - one) & crosses;
        other += (i - other) & crosses;
        side = next;
    }
    if (one < 0) return side < 0 ? TUFF_MISSES : TUFF_UNSURE;
    at->earlier.from = &vertices[one];
    at->earlier.to = &vertices[one == last ? 0 : one + 1];
    at->later.from = &vertices[other];
    at->later.to = &vertices[other + 1];
    at->up_first = side < 0;
    return TUFF_MEETS;
}

/* The line meets the polygon between the two edges that cross it, and the segment misses if b is before both of them or,
   the other way along, a is. A vertex on the line counts as being on the other side than the first vertex, so that the line
   misses where no edge crosses it; with the first on the line itself, as being on the left, which tells nothing if
   the others are, too. */
TUFF_HOT tuff_verdict tuff_near_verdict(const tuff_vec2 *a, const tuff_vec2 *b, const tuff_polygon *polygon)
{
    tuff_crossings at;
    if (!tuff_is_near(a, b)) return TUFF_UNSURE;
    const tuff_vec2 *first = polygon->vertices;
    const int32_t dx = b->x - a->x;
    const int32_t back = a->y - b->y;
    int64_t across = tuff_dot32(dx, back, a->y, a->x);
    int64_t side = tuff_dot32(dx, back, first->y, first->x);
    int64_t limit = across + (side > across ? 1 : 0);
    tuff_verdict verdict = tuff_find_crossings(polygon, dx, back, limit, tuff_area_sub(side, limit), &at);
    if (verdict == TUFF_UNSURE && side != across) return TUFF_MISSES;
    if (verdict != TUFF_MEETS) return verdict;
    const tuff_vec2 *head = at.up_first ? b : a;
    const tuff_vec2 *tail = at.up_first ? a : b;
    unsigned missed = tuff_before_both(&at.earlier, &at.later, head) | tuff_before_both(&at.later, &at.earlier, tail);
    return missed != 0 ? TUFF_MISSES : TUFF_MEETS;
}
