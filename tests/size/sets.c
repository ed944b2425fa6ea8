/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The feature sets of the size table: set_NAME makes exactly the public calls of a set, and those of the set before. Linked, never run. */
#include <tuff/tuff.h>

typedef struct game {
    tuff_world   world;
    tuff_terrain piece;
    tuff_body    body;
    tuff_polygon hull;
    tuff_contact contact;
    tuff_touches touches;
    tuff_beam_hit hit;
    tuff_vec2    a, b;
    tuff_real    radius;
    tuff_unit2   normals[TUFF_MAX_VERTICES];
    uint16_t     number;
    tuff_fault   fault;
    const char  *text;
    volatile bool done;         /* each answer is wanted */
    volatile uint16_t count;
} game;

void set_circle(game *g);
void set_hull(game *g);
void set_beams(game *g);
void set_chunks(game *g);
void set_all(game *g);
void set_checks(game *g);

/* The _circle calls and the bounce. The collide calls read an index, if there is one. */
void set_circle(game *g)
{
    g->count = tuff_terrain_collide_circle(&g->world, &g->body, g->radius);
    g->count = tuff_floater_collide_circle(&g->body, g->radius, &g->piece, g->number);
    g->done = tuff_terrain_overlap_circle(&g->piece, g->a, g->radius, &g->contact);
    g->done = tuff_circle_circle(g->a, g->radius, g->radius, &g->contact);
    tuff_bounce(&g->body, &g->contact);
}

void set_hull(game *g)
{
    set_circle(g);
    g->count = tuff_terrain_collide(&g->world, &g->body, g->radius, &g->hull);
    g->count = tuff_floater_collide(&g->body, g->radius, &g->piece, g->number, &g->hull);
    g->done = tuff_terrain_overlap_hull(&g->piece, g->a, g->radius, &g->hull, &g->contact);
    tuff_edge_normals(&g->a, g->hull.count, g->normals);
}

void set_beams(game *g)
{
    set_hull(g);
    g->done = tuff_segment_terrain_intersect(&g->world, g->a, g->b);
    g->done = tuff_segment_terrain_first_hit(&g->world, g->a, g->b, &g->hit);
}

/* Making and changing the index, and asking it. */
void set_chunks(game *g)
{
    set_beams(g);
    tuff_chunks_clear(g->world.chunks);
    g->done = tuff_chunks_insert(g->world.chunks, g->number, g->a, g->radius);
    g->done = tuff_chunks_move(g->world.chunks, g->number, g->b, g->radius);
    g->done = tuff_chunks_remove(g->world.chunks, g->number);
    g->count = tuff_world_index(&g->world);
    g->count = tuff_nearby_terrain(&g->world, g->a, g->radius);
}

/* Every call of a frame. */
void set_all(game *g)
{
    set_chunks(g);
    g->body.material = &tuff_default_material;
    g->done = tuff_circle_polygon(g->a, g->radius, &g->hull, &g->contact);
    g->done = tuff_polygon_polygon(&g->hull, g->a, &g->hull, &g->contact);
    g->done = tuff_segment_circle(g->a, g->b, g->radius);
    g->done = tuff_segment_polygon(g->a, g->b, &g->hull);
    g->count = tuff_terrain_collide_report(&g->world, &g->body, g->radius, &g->hull, &g->touches);
    g->count = tuff_floater_collide_report(&g->body, g->radius, &g->piece, g->number, &g->hull, g->world.order, &g->touches);
    g->count = tuff_substeps(g->a, g->radius, tuff_polygon_thickness(&g->hull));
}

/* And what debug builds and tools call. */
void set_checks(game *g)
{
    set_all(g);
    g->fault = tuff_check_polygon(&g->hull);
    g->fault = tuff_check_hull(&g->hull);
    g->fault = tuff_check_terrain(&g->piece);
    g->fault = tuff_check_body(&g->body, g->radius, &g->hull);
    g->fault = tuff_check_world(&g->world, &g->number);
    g->text = tuff_fault_text(g->fault);
}
