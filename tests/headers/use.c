/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Uses something of each header, literals in static initializers and every converter. Compiled in many surroundings, never linked. */
#ifdef BEFORE
#include BEFORE
#endif
#include <tuff/tuff.h>
#ifdef AFTER
#include AFTER
#endif

int use(void);

static const tuff_vec2 square[4] = {
    { TUFF_REAL(-12.5), TUFF_REAL(-12.5) }, { TUFF_RATIO(25, 2), TUFF_RATIO(-25, 2) },
    { TUFF_REAL_RAW(819200), TUFF_REAL_RAW(819200) }, { TUFF_RATIO(-25, 2), TUFF_RATIO(25, 2) }
};
static const tuff_unit2 normals[4] = {
    { 0, TUFF_UNIT(-1) }, { TUFF_UNIT_RATIO(1, 1), 0 }, { 0, TUFF_UNIT_RAW(1073741824) }, { TUFF_UNIT(-1.0), TUFF_UNIT(0.0) }
};
static const tuff_polygon part = { square, normals, 0, 4 };
static tuff_terrain terrain[1] = { { { TUFF_WHOLE(100), TUFF_WHOLE(-100) }, TUFF_WHOLE(17), TUFF_WHOLE(18), &part, 1 } };
static uint16_t buckets[4];
static tuff_chunk_entry entries[1];
static tuff_chunks chunks = TUFF_CHUNKS(buckets, entries, 6);
static uint16_t nearby[1];
static tuff_world world = { terrain, 1, &chunks, nearby, 1, TUFF_ORDER_DEEPEST };
static const tuff_material bumper = { TUFF_REAL(1.5), 0 };

static tuff_real convert(tuff_real value)
{
    value = tuff_from_int(tuff_to_int(value));
    value = tuff_from_float(tuff_to_float(value));
    value = tuff_from_q16_16(tuff_to_q16_16(value));
    value = tuff_from_q24_8(tuff_to_q24_8(value));
    value = tuff_from_q20_12(tuff_to_q20_12(value));
    value = tuff_from_q22_10(tuff_to_q22_10(value));
    return tuff_from_q10_6(tuff_to_q10_6(value));
}

int use(void)
{
    tuff_body body = { { TUFF_WHOLE(100), convert(TUFF_WHOLE(-80)) }, { 0, TUFF_WHOLE(-1) }, &bumper };
    tuff_touch touch;
    tuff_touches touches = { &touch, 1, 0 };
    tuff_beam_hit hit;
    if (tuff_world_index(&world) != 0 || tuff_check_world(&world, NULL) != TUFF_OK) return 1;
    if (tuff_substeps(body.velocity, TUFF_WHOLE(8), tuff_polygon_thickness(&part)) != 1) return 5;
    if (tuff_nearby_terrain(&world, body.position, TUFF_WHOLE(8)) != 1) return 2;
    if (!tuff_terrain_collide_report(&world, &body, TUFF_WHOLE(8), &part, &touches)) return 3;
    return tuff_segment_terrain_first_hit(&world, body.position, terrain[0].position, &hit) ? 0 : 4;
}
