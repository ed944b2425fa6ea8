/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Square roots, directions, the bounce and the beam's fractions in float. Only arith.c includes this. */
#include <math.h>

/* A component below 2^-32 turns the direction by less than its rounding. */
static float tuff_component(float component, float length)
{
    return tuff_abs(component) < length * 2.3283064e-10f ? 0.0f : tuff_clamp(component / length, 1.0f);
}

tuff_real tuff_normalize_xy(tuff_real x, tuff_real y, tuff_unit2 *direction)
{
    const tuff_vec2 v = { x, y };
    tuff_vec2 d = tuff_vec2_flush(v);
    float length = sqrtf(tuff_dot(d, d));
    if (!(length > 0.0f)) return 0.0f;
    direction->x = tuff_component(d.x, length);
    direction->y = tuff_component(d.y, length);
    return length;
}

static float tuff_speed(float v)
{
    return tuff_clamp(tuff_flush(v), (float)TUFF_MAX_SPEED);
}

void tuff_reflect(tuff_vec2 *v, tuff_unit2 n, tuff_real restitution, tuff_real friction)
{
    tuff_vec2 before = tuff_vec2_flush(*v);
    float inward = tuff_flush(tuff_project(n, before));
    if (!(inward < 0.0f)) return;
    float keep = 1.0f - friction;
    float change = tuff_flush((keep + restitution) * inward);
    v->x = tuff_speed(keep * before.x - change * n.x);
    v->y = tuff_speed(keep * before.y - change * n.y);
}

/* --- beams ------------------------------------------------------------------------------------------------- */

bool tuff_chord_reaches(tuff_area across, const tuff_far2 *d, tuff_real radius)
{
    return tuff_abs(across) <= radius * sqrtf(tuff_dot(*d, *d));
}

tuff_unit tuff_ratio(tuff_area numerator, tuff_area denominator)
{
    float ratio = tuff_flush(numerator) / denominator;
    return ratio < 1.0f ? ratio : 1.0f;
}

bool tuff_ratio_less(const tuff_ratio_of *a, const tuff_ratio_of *b)
{
    return tuff_ratio(a->part, a->whole) < tuff_ratio(b->part, b->whole);
}

tuff_unit2 tuff_far_direction(const tuff_far2 *d)
{
    tuff_unit2 direction = { 1.0f, 0.0f };
    (void)tuff_normalize(*d, &direction);
    return direction;
}

/* The foot of the center lies -a . u along the line and a x u beside it; the circle is entered sqrt(radius^2 -
   beside^2) earlier. */
tuff_unit tuff_circle_entry(const tuff_far2 *a, const tuff_far2 *d, tuff_real radius)
{
    tuff_unit2 u = { 1.0f, 0.0f };
    float length = tuff_normalize(*d, &u);
    float ahead = -tuff_project(u, *a);
    float beside = tuff_abs(a->x * u.y - a->y * u.x);
    float chord = beside < radius ? sqrtf((radius - beside) * (radius + beside)) : 0.0f;
    float entry = ahead - chord;
    return entry > 0.0f && length > 0.0f ? tuff_ratio(entry, length) : 0.0f;
}

tuff_vec2 tuff_along(const tuff_far2 *a, const tuff_far2 *d, tuff_unit fraction)
{
    tuff_vec2 point = { a->x + fraction * d->x, a->y + fraction * d->y };
    return tuff_vec2_flush(point);
}
