/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Square roots, directions, the bounce and the beam's fractions in integers. Only arith.c includes this. No floating
   point, and no division but in the three functions of a beam's first hit. */

/* An even shift that brings q > 0 to [2^62, 2^64). */
static unsigned tuff_even_shift(uint64_t q)
{
    unsigned shift = 0;
    unsigned step;
    for (step = 32; step >= 2; step /= 2) {
        if (q >> (64 - step) == 0) {
            q <<= step;
            shift += step;
        }
    }
    return shift;
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

    uint64_t uy = (uint64_t)u * y1 + (((q & 0xFFFFFFFFu) * y1) >> 32);     /* Q48 */
    int64_t residue = ((int64_t)1 << 61) - (int64_t)((uy >> 3) * y1);      /* Q61 */
    int32_t e = (int32_t)(residue >> 20);                                  /* Q41, below 2^30 */
    int64_t series = (e >> 1) + ((3 * (((int64_t)e * e) >> 41)) >> 3);
    int64_t y = ((int64_t)y1 << 15) + ((y1 * series + ((int64_t)1 << 25)) >> 26);
    return y > TUFF_UINT32_MAX ? TUFF_UINT32_MAX : (uint32_t)y;
}

/* The integer closest to sqrt(square), from inverse = tuff_inverse_root(square << shift). sqrt(u) = u / sqrt(u) is
   within two steps of the integer; n is closest if n^2 - n < square <= n^2 + n. */
static uint32_t tuff_root_from(uint64_t square, unsigned shift, uint32_t inverse)
{
    uint64_t root = ((((square << shift) >> 32) * inverse) >> 31) >> (shift / 2);
    while (root * root + root < square) ++root;
    while (root * root - root >= square && root > 0) --root;
    return (uint32_t)root;
}

static uint32_t tuff_root(uint64_t square)
{
    if (square == 0) return 0;
    unsigned shift = tuff_even_shift(square);
    return tuff_root_from(square, shift, tuff_inverse_root(square << shift));
}

/* component / length in Q2.30: component * 2^(shift/2) < 2^32 and inverse / 2^31 = 2^(32 - shift/2) / length. */
static tuff_unit tuff_component(int32_t component, unsigned shift, uint32_t inverse)
{
    uint32_t size = component < 0 ? 0u - (uint32_t)component : (uint32_t)component;
    int32_t unit = (int32_t)(((uint64_t)(size << (shift / 2)) * inverse + ((uint64_t)1 << 32)) >> 33);
    return component < 0 ? -unit : unit;
}

tuff_real tuff_normalize(tuff_vec2 v, tuff_unit2 *direction)
{
    uint64_t square = (uint64_t)((int64_t)v.x * v.x) + (uint64_t)((int64_t)v.y * v.y);
    if (square == 0) return 0;
    unsigned shift = tuff_even_shift(square);
    uint32_t inverse = tuff_inverse_root(square << shift);
    direction->x = v.y == 0 ? (v.x < 0 ? -TUFF_UNIT_ONE : TUFF_UNIT_ONE) : tuff_component(v.x, shift, inverse);
    direction->y = v.x == 0 ? (v.y < 0 ? -TUFF_UNIT_ONE : TUFF_UNIT_ONE) : tuff_component(v.y, shift, inverse);
    uint32_t length = tuff_root_from(square, shift, inverse);
    return length > TUFF_INT32_MAX ? TUFF_INT32_MAX : (tuff_real)length;
}

static tuff_real tuff_toward_zero(int64_t a, unsigned bits)
{
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
    int64_t keep = ((int32_t)1 << TUFF_REAL_BITS) - friction;
    /* Q46 * Q16 has more than 64 bits: the high 46 - 30 bits first. All is of one sign, so this rounds toward zero as well. */
    int64_t change = -(((((-inward) >> 16) * (keep + restitution)) >> 26));
    int64_t x = (int64_t)((uint64_t)(keep * vx * ((int64_t)1 << 18)) - (uint64_t)change * (uint64_t)(int64_t)n.x);
    int64_t y = (int64_t)((uint64_t)(keep * vy * ((int64_t)1 << 18)) - (uint64_t)change * (uint64_t)(int64_t)n.y);
    v->x = tuff_toward_zero(x, 50 - TUFF_REAL_BITS);
    v->y = tuff_toward_zero(y, 50 - TUFF_REAL_BITS);
}

/* --- beams ------------------------------------------------------------------------------------------------- */

typedef struct tuff_u128 { uint64_t high, low; } tuff_u128;

static tuff_u128 tuff_multiply(uint64_t a, uint64_t b)
{
    uint64_t ah = a >> 32, al = a & 0xFFFFFFFFu;
    uint64_t bh = b >> 32, bl = b & 0xFFFFFFFFu;
    uint64_t low = al * bl;
    uint64_t middle = ah * bl + (low >> 32);
    uint64_t other = al * bh + (middle & 0xFFFFFFFFu);
    tuff_u128 product = { ah * bh + (middle >> 32) + (other >> 32), (other << 32) | (low & 0xFFFFFFFFu) };
    return product;
}

static uint64_t tuff_size64(int64_t a)
{
    return a < 0 ? 0u - (uint64_t)a : (uint64_t)a;
}

/* across^2 <= (radius d.x)^2 + (radius d.y)^2: the right side has at most 2 * (27 + 33) + 1 bits. */
bool tuff_chord_reaches(tuff_area across, tuff_far2 d, tuff_real radius)
{
    tuff_u128 left = tuff_multiply(tuff_size64(across), tuff_size64(across));
    tuff_u128 x = tuff_multiply(tuff_size64(d.x) * (uint32_t)radius, tuff_size64(d.x) * (uint32_t)radius);
    tuff_u128 y = tuff_multiply(tuff_size64(d.y) * (uint32_t)radius, tuff_size64(d.y) * (uint32_t)radius);
    uint64_t low = x.low + y.low;
    uint64_t high = x.high + y.high + (low < x.low ? 1 : 0);
    return left.high < high || (left.high == high && left.low <= low);
}

bool tuff_ratio_less(tuff_area n1, tuff_area d1, tuff_area n2, tuff_area d2)
{
    tuff_u128 left = tuff_multiply((uint64_t)n1, (uint64_t)d2);
    tuff_u128 right = tuff_multiply((uint64_t)n2, (uint64_t)d1);
    return left.high < right.high || (left.high == right.high && left.low < right.low);
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

/* A vector of 33-bit components with components up to 2^30, so that its length fits too: divided by 4 where it is longer. */
static unsigned tuff_far_reduce(tuff_far2 d, tuff_vec2 *reduced)
{
    const uint64_t limit = (uint64_t)1 << 30;
    bool large = tuff_size64(d.x) > limit || tuff_size64(d.y) > limit;
    reduced->x = (int32_t)(large ? d.x / 4 : d.x);
    reduced->y = (int32_t)(large ? d.y / 4 : d.y);
    return large ? 2 : 0;
}

tuff_unit2 tuff_far_direction(tuff_far2 d)
{
    tuff_vec2 reduced;
    tuff_unit2 direction = { TUFF_UNIT_ONE, 0 };
    (void)tuff_far_reduce(d, &reduced);
    (void)tuff_normalize(reduced, &direction);
    return direction;
}

/* The foot of the center lies -a . u along the line and a x u beside it; the circle is entered sqrt(radius^2 -
   beside^2) earlier. All three lengths in Q21 (5 bits below the LSB): radius < 2^31.5 / 2^21, so the squares fit 64
   bits. |a| <= 2^32.5, so a . u in Q46 fits. */
tuff_unit tuff_circle_entry(tuff_far2 a, tuff_far2 d, tuff_real radius)
{
    tuff_vec2 reduced;
    tuff_unit2 u = { TUFF_UNIT_ONE, 0 };
    unsigned reduction = tuff_far_reduce(d, &reduced);
    int64_t length = (int64_t)tuff_normalize(reduced, &u) * ((int64_t)32 << reduction);
    int64_t ahead = tuff_shift_nearest(-(a.x * u.x + a.y * u.y), 25);
    uint64_t beside = tuff_size64(tuff_shift_nearest(a.x * u.y - a.y * u.x, 25));
    uint64_t reach = (uint64_t)radius * 32;
    int64_t chord = beside < reach ? (int64_t)tuff_root(reach * reach - beside * beside) : 0;
    int64_t entry = ahead - chord;
    return tuff_ratio(entry < 0 ? 0 : entry > length ? length : entry, length);
}

tuff_vec2 tuff_along(tuff_far2 a, tuff_far2 d, tuff_unit fraction)
{
    tuff_vec2 point = { (tuff_real)(a.x + tuff_shift_nearest(d.x * fraction, TUFF_UNIT_BITS)),
                        (tuff_real)(a.y + tuff_shift_nearest(d.y * fraction, TUFF_UNIT_BITS)) };
    return point;
}
