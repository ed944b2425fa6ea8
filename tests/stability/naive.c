/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The textbook's frame call. */
#include "naive.h"

void naive_read(naive_polygon *naive, const tuff_polygon *polygon)
{
    textbook_normals(polygon->vertices, polygon->count, naive->normals);
    naive->polygon = (textbook_polygon){ polygon->vertices, naive->normals, polygon->count };
}

static bool overlap(const tuff_polygon *part, tuff_vec2 offset, tuff_real radius, const textbook_polygon *hull, textbook_contact *contact)
{
    naive_polygon rock;
    naive_read(&rock, part);
    return hull ? textbook_hull(hull, offset, &rock.polygon, contact) : textbook_circle(offset, radius, &rock.polygon, contact);
}

/* The bounding circles' boxes first, as games do: the squares of plain Q16.16 overflow beyond 181 units. */
static bool is_near(const tuff_terrain *piece, const tuff_body *body, tuff_real radius)
{
    tuff_real reach = piece->bounding_radius + radius;
    tuff_real x = body->position.x - piece->position.x, y = body->position.y - piece->position.y;
    return x < reach && -x < reach && y < reach && -y < reach;
}

static uint16_t collide_piece(const tuff_terrain *piece, tuff_body *body, tuff_real radius, const textbook_polygon *hull)
{
    textbook_contact contact;
    uint16_t pushes = 0;
    if (!is_near(piece, body, radius)) return 0;
    for (int i = 0; i < piece->part_count; i++) {
        tuff_vec2 offset = { body->position.x - piece->position.x, body->position.y - piece->position.y };
        if (!overlap(&piece->parts[i], offset, radius, hull, &contact)) continue;
        textbook_bounce(body, &contact);
        pushes++;
    }
    return pushes;
}

uint16_t naive_collide(const tuff_terrain *terrain, uint16_t count, tuff_body *body, tuff_real radius, const tuff_polygon *hull)
{
    naive_polygon own;
    uint16_t pushes = 0;
    if (hull) naive_read(&own, hull);
    for (uint16_t i = 0; i < count; i++) pushes = (uint16_t)(pushes + collide_piece(&terrain[i], body, radius, hull ? &own.polygon : NULL));
    return pushes;
}
