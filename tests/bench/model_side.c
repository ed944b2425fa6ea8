/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The build that this file is compiled for, behind model_side.h. */
#include "model_side.h"

#include "tuff/tuff.h"

#if TUFF_SCALAR == TUFF_Q16_16
#define SIDE model_side_q16
#define SIDE_NAME "q16"
#else
#define SIDE model_side_float
#define SIDE_NAME "float"
#endif

typedef struct baked {
    tuff_world   world;             /* of this one piece */
    tuff_terrain piece;
    tuff_polygon parts[MODEL_MOST_PARTS];
    tuff_vec2    vertices[MODEL_MOST_VERTICES];
    tuff_unit2   normals[MODEL_MOST_VERTICES];
} baked;

static baked models[MODEL_MOST];
static struct { tuff_vec2 middle, from, to; } places[MODEL_MOST_PLACES];
static tuff_real radius;
static tuff_vec2 hull_vertices[BENCH_MAX_VERTICES];
static tuff_unit2 hull_normals[BENCH_MAX_VERTICES];
static tuff_polygon hull;

static tuff_vec2 vec(int32_t x, int32_t y)
{
    return (tuff_vec2){ tuff_from_q16_16(x), tuff_from_q16_16(y) };
}

static tuff_polygon polygon(const bench_point *points, int count, uint32_t internal, tuff_vec2 *vertices, tuff_unit2 *normals)
{
    for (int i = 0; i < count; i++) vertices[i] = vec(points[i].x, points[i].y);
    tuff_edge_normals(vertices, (uint8_t)count, normals);
    return (tuff_polygon){ vertices, normals, internal, (uint8_t)count };
}

static void bake(int model, const model_source *source)
{
    baked *made = &models[model];
    int first = 0;
    for (int i = 0; i < source->part_count; i++) {
        const model_part *part = &source->parts[i];
        made->parts[i] = polygon(source->vertices + first, part->count, part->internal, made->vertices + first, made->normals + first);
        first += part->count;
    }
    made->piece = (tuff_terrain){ vec(source->position.x, source->position.y), tuff_from_q16_16(source->radius),
                                  tuff_from_q16_16(source->bounding_radius), made->parts, (uint8_t)source->part_count };
    made->world = (tuff_world){ &made->piece, 1, NULL, NULL, 0, TUFF_ORDER_ITERATION };
}

static void prepare(const model_queries *queries, const model_place *list, int count)
{
    radius = tuff_from_q16_16(queries->radius);
    hull = polygon(queries->hull.vertices, queries->hull.count, 0, hull_vertices, hull_normals);
    for (int i = 0; i < count; i++) {
        bench_point middle = list[i].middle, reach = list[i].reach;
        places[i].middle = vec(middle.x, middle.y);
        places[i].from = vec(middle.x - reach.x, middle.y - reach.y);
        places[i].to = vec(middle.x + reach.x, middle.y + reach.y);
    }
}

#define HITS(answer) for (uint32_t i = 0; i < count; i++) { uint16_t at = order[i]; hits += (answer); }

static uint32_t run(int what, const uint16_t *order, uint32_t count)
{
    const baked *model = &models[what / MODEL_QUERIES];
    int query = what % MODEL_QUERIES;
    uint32_t hits = 0;
    tuff_contact contact;
    if (query == MODEL_CIRCLE) HITS(tuff_terrain_overlap_circle(&model->piece, places[at].middle, radius, &contact))
    if (query == MODEL_HULL) HITS(tuff_terrain_overlap_hull(&model->piece, places[at].middle, radius, &hull, &contact))
    if (query == MODEL_BEAM) HITS(tuff_segment_terrain_intersect(&model->world, places[at].from, places[at].to))
    return hits;
}

const model_side SIDE = { SIDE_NAME, bake, prepare, run };
