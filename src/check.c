/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Validation of shapes, pieces, bodies and worlds. Every limit is the constant of shapes.h that the library computes
   with. */
#include "inner.h"

/* How far each component of a normal may be from that of its edge: ten times what rounding makes of a good one in float. */
#define NORMAL_TOLERANCE TUFF_UNIT_RATIO(2, 1000000)

/* Within +-limit whole units. */
static bool is_within(tuff_real a, int32_t limit)
{
    return a <= TUFF_WHOLE(limit) && a >= -TUFF_WHOLE(limit);
}

/* --- polygons ---------------------------------------------------------------------------------------------- */

static tuff_fault check_vertices(const tuff_polygon *polygon)
{
    uint8_t i;
    for (i = 0; i < polygon->count; ++i) {
        tuff_vec2 v = polygon->vertices[i];
        tuff_vec2 next = polygon->vertices[tuff_next_index(i, polygon->count)];
        if (!tuff_number_ok(v.x) || !tuff_number_ok(v.y)) return TUFF_FAULT_NOT_FINITE;
        if (!is_within(v.x, TUFF_MAX_EXTENT) || !is_within(v.y, TUFF_MAX_EXTENT)) return TUFF_FAULT_VERTEX_RANGE;
        if (v.x == next.x && v.y == next.y) return TUFF_FAULT_DUPLICATE_VERTEX;
    }
    return TUFF_OK;
}

/* Sign of the turn at vertex i: 1, -1, or 0 for straight on. */
static int turn_at(const tuff_polygon *polygon, uint8_t i)
{
    tuff_vec2 before = polygon->vertices[tuff_previous_index(i, polygon->count)];
    tuff_vec2 after = polygon->vertices[tuff_next_index(i, polygon->count)];
    tuff_area cross = tuff_cross(tuff_vec2_gap(polygon->vertices[i], before), tuff_vec2_gap(after, polygon->vertices[i]));
    return cross > 0 ? 1 : cross < 0 ? -1 : 0;
}

/* Is the edge from vertex i on the way up? Level edges count with the way right, so that a turn all round changes it
   twice. */
static bool ascends(const tuff_polygon *polygon, uint8_t i)
{
    tuff_vec2 from = polygon->vertices[i];
    tuff_vec2 to = polygon->vertices[tuff_next_index(i, polygon->count)];
    return to.y > from.y || (to.y == from.y && to.x > from.x);
}

/* Convex: all turns of one sign, and once round: the edges change between up and down twice. An edge that turns
   straight back is no turn by its sign but a change too many, or leaves no area. */
static tuff_fault check_convex(const tuff_polygon *polygon)
{
    bool left = false;
    bool right = false;
    uint8_t changes = 0;
    uint8_t i;
    for (i = 0; i < polygon->count; ++i) {
        int turn = turn_at(polygon, i);
        if (turn > 0) left = true;
        if (turn < 0) right = true;
        if (ascends(polygon, i) != ascends(polygon, tuff_previous_index(i, polygon->count))) ++changes;
    }
    if (!left && !right) return TUFF_FAULT_NO_AREA;
    return (left && right) || changes != 2 ? TUFF_FAULT_CONCAVE : TUFF_OK;
}

/* |n|^2 is within 2^-18 of 1 before the components are compared, so that their differences are small numbers. */
static tuff_fault check_normal(tuff_unit2 n, tuff_unit2 exact)
{
    tuff_wide one = tuff_facing(exact, exact);
    tuff_wide square = tuff_facing(n, n);
    tuff_wide tolerance = one / 262144;
    if (!(square <= one + tolerance && square >= one - tolerance)) return TUFF_FAULT_NORMAL_LENGTH;
    if (tuff_facing(n, exact) < 0) return TUFF_FAULT_NORMAL_INWARD;
    tuff_unit x = n.x - exact.x;
    tuff_unit y = n.y - exact.y;
    bool same = x <= NORMAL_TOLERANCE && x >= -NORMAL_TOLERANCE && y <= NORMAL_TOLERANCE && y >= -NORMAL_TOLERANCE;
    return same ? TUFF_OK : TUFF_FAULT_NORMAL_DIRECTION;
}

static tuff_fault check_normals(const tuff_polygon *polygon)
{
    tuff_unit2 exact[TUFF_MAX_VERTICES];
    uint8_t i;
    tuff_edge_normals(polygon->vertices, polygon->count, exact);
    for (i = 0; i < polygon->count; ++i) {
        tuff_fault fault = check_normal(polygon->normals[i], exact[i]);
        if (fault != TUFF_OK) return fault;
    }
    return TUFF_OK;
}

tuff_fault tuff_check_hull(const tuff_polygon *hull)
{
    tuff_fault fault;
    if (hull == NULL || hull->vertices == NULL) return TUFF_FAULT_NULL;
    if (hull->count < 3) return TUFF_FAULT_TOO_FEW_VERTICES;
    if (hull->count > TUFF_MAX_VERTICES) return TUFF_FAULT_TOO_MANY_VERTICES;
    if (hull->count < TUFF_MAX_VERTICES && hull->internal_edges >> hull->count != 0) return TUFF_FAULT_INTERNAL_BITS;
    fault = check_vertices(hull);
    if (fault == TUFF_OK) fault = check_convex(hull);
    if (fault == TUFF_OK && hull->normals != NULL) fault = check_normals(hull);
    return fault;
}

tuff_fault tuff_check_polygon(const tuff_polygon *polygon)
{
    tuff_fault fault = tuff_check_hull(polygon);
    return fault == TUFF_OK && polygon->normals == NULL ? TUFF_FAULT_NO_NORMALS : fault;
}

/* --- pieces ------------------------------------------------------------------------------------------------ */

/* Does the circle about the owner's position cover all vertices, to the nearest number that the build has? */
static bool covers(tuff_real radius, const tuff_polygon *polygon)
{
    tuff_unit2 unused;
    uint8_t i;
    for (i = 0; i < polygon->count; ++i) {
        if (tuff_normalize(polygon->vertices[i], &unused) > radius) return false;
    }
    return true;
}

static bool has_internal_edge(const tuff_polygon *polygon, tuff_vec2 a, tuff_vec2 b)
{
    uint8_t i;
    for (i = 0; i < polygon->count; ++i) {
        tuff_vec2 from = polygon->vertices[i];
        tuff_vec2 to = polygon->vertices[tuff_next_index(i, polygon->count)];
        bool same = from.x == a.x && from.y == a.y && to.x == b.x && to.y == b.y;
        bool swapped = from.x == b.x && from.y == b.y && to.x == a.x && to.y == a.y;
        if (tuff_edge_is_internal(polygon, i) && (same || swapped)) return true;
    }
    return false;
}

/* Has every internal edge of this part its other side? */
static bool internal_edges_matched(const tuff_terrain *piece, uint8_t part)
{
    const tuff_polygon *polygon = &piece->parts[part];
    uint8_t i, other;
    for (i = 0; i < polygon->count; ++i) {
        bool matched = !tuff_edge_is_internal(polygon, i);
        for (other = 0; other < piece->part_count && !matched; ++other) {
            matched = other != part && has_internal_edge(&piece->parts[other], polygon->vertices[i],
                                                         polygon->vertices[tuff_next_index(i, polygon->count)]);
        }
        if (!matched) return false;
    }
    return true;
}

static tuff_fault check_parts(const tuff_terrain *piece)
{
    uint8_t i;
    for (i = 0; i < piece->part_count; ++i) {
        tuff_fault fault = tuff_check_polygon(&piece->parts[i]);
        if (fault != TUFF_OK) return fault;
        if (!covers(piece->bounding_radius, &piece->parts[i])) return TUFF_FAULT_BOUNDING_TOO_SMALL;
    }
    for (i = 0; i < piece->part_count; ++i) {
        if (!internal_edges_matched(piece, i)) return TUFF_FAULT_INTERNAL_UNMATCHED;
    }
    return TUFF_OK;
}

static bool is_empty_slot(const tuff_terrain *piece)
{
    return piece->bounding_radius == TUFF_WHOLE(0) && piece->radius == TUFF_WHOLE(0) && piece->parts == NULL && piece->part_count == 0;
}

tuff_fault tuff_check_terrain(const tuff_terrain *piece)
{
    if (piece == NULL) return TUFF_FAULT_NULL;
    if (is_empty_slot(piece)) return TUFF_OK;
    if (!tuff_number_ok(piece->position.x) || !tuff_number_ok(piece->position.y)) return TUFF_FAULT_NOT_FINITE;
    if (!tuff_number_ok(piece->radius) || !tuff_number_ok(piece->bounding_radius)) return TUFF_FAULT_NOT_FINITE;
    if (!tuff_position_ok(piece->position)) return TUFF_FAULT_POSITION_RANGE;
    if (!tuff_in_range(piece->radius, TUFF_MAX_RADIUS)) return TUFF_FAULT_RADIUS_RANGE;
    if (!tuff_is_piece(piece)) return TUFF_FAULT_BOUNDING_RANGE;
    if (piece->bounding_radius < piece->radius) return TUFF_FAULT_BOUNDING_TOO_SMALL;
    return piece->parts == NULL ? TUFF_OK : check_parts(piece);
}

/* --- bodies ------------------------------------------------------------------------------------------------ */

static tuff_fault check_material(const tuff_material *material)
{
    if (material == NULL) return TUFF_OK;
    if (!tuff_number_ok(material->restitution) || !tuff_number_ok(material->friction)) return TUFF_FAULT_NOT_FINITE;
    if (!tuff_in_range(material->restitution, TUFF_MAX_RESTITUTION)) return TUFF_FAULT_RESTITUTION_RANGE;
    return tuff_in_range(material->friction, TUFF_MAX_FRICTION) ? TUFF_OK : TUFF_FAULT_FRICTION_RANGE;
}

tuff_fault tuff_check_body(const tuff_body *body, tuff_real radius, const tuff_polygon *hull)
{
    if (body == NULL) return TUFF_FAULT_NULL;
    if (!tuff_number_ok(body->position.x) || !tuff_number_ok(body->position.y)) return TUFF_FAULT_NOT_FINITE;
    if (!tuff_number_ok(body->velocity.x) || !tuff_number_ok(body->velocity.y) || !tuff_number_ok(radius)) return TUFF_FAULT_NOT_FINITE;
    if (!tuff_position_ok(body->position)) return TUFF_FAULT_POSITION_RANGE;
    if (!is_within(body->velocity.x, TUFF_MAX_SPEED) || !is_within(body->velocity.y, TUFF_MAX_SPEED)) return TUFF_FAULT_VELOCITY_RANGE;
    if (!tuff_in_range(radius, hull == NULL ? TUFF_MAX_RADIUS : TUFF_MAX_BOUNDING_RADIUS)) return TUFF_FAULT_RADIUS_RANGE;
    if (hull != NULL) {
        tuff_fault fault = tuff_check_hull(hull);
        if (fault != TUFF_OK) return fault;
        if (!covers(radius, hull)) return TUFF_FAULT_HULL_RADIUS;
    }
    return check_material(body->material);
}

/* --- worlds ------------------------------------------------------------------------------------------------ */

/* Is the list that starts with this link a list? Never longer than there are entries. */
static bool is_list(const tuff_chunks *chunks, uint16_t link)
{
    uint32_t left = chunks->capacity;
    while (tuff_link_valid(chunks, link) && left > 0) {
        link = chunks->entries[link - 1].next;
        --left;
    }
    return link == TUFF_LIST_END || link == 0;
}

static bool is_listed(const tuff_chunks *chunks, uint16_t link, uint16_t piece)
{
    while (tuff_link_valid(chunks, link) && link != piece + 1) link = chunks->entries[link - 1].next;
    return link == piece + 1;
}

static tuff_fault check_storage(const tuff_chunks *chunks)
{
    uint16_t i;
    if (chunks->buckets == NULL || chunks->entries == NULL) return TUFF_FAULT_NULL;
    if (chunks->bucket_count == 0 || (chunks->bucket_count & (chunks->bucket_count - 1)) != 0) return TUFF_FAULT_BUCKET_COUNT;
    if (chunks->pitch_log2 > TUFF_MAX_PITCH_LOG2) return TUFF_FAULT_PITCH;
    if (!is_list(chunks, chunks->large)) return TUFF_FAULT_INDEX_BROKEN;
    for (i = 0; i < chunks->bucket_count; ++i) {
        if (!is_list(chunks, chunks->buckets[i])) return TUFF_FAULT_INDEX_BROKEN;
    }
    return TUFF_OK;
}

/* Has the index this piece (NULL: none) where it ought to? */
static tuff_fault check_entry(const tuff_chunks *chunks, uint16_t number, const tuff_terrain *piece)
{
    bool exists = piece != NULL && piece->bounding_radius > TUFF_WHOLE(0);
    if (number >= chunks->capacity || chunks->entries[number].next == 0) return exists ? TUFF_FAULT_INDEX_MISSING : TUFF_OK;
    const tuff_chunk_entry *entry = &chunks->entries[number];
    bool large = is_listed(chunks, chunks->large, number);
    uint16_t bucket = chunks->buckets[tuff_bucket(chunks, entry->x, entry->y)];
    if (!large && !is_listed(chunks, bucket, number)) return TUFF_FAULT_INDEX_BROKEN;
    if (!exists) return TUFF_FAULT_INDEX_STALE;
    int32_t x = tuff_chunk_of(chunks, tuff_floor(piece->position.x));
    int32_t y = tuff_chunk_of(chunks, tuff_floor(piece->position.y));
    bool covered = large || tuff_ceil(piece->bounding_radius) <= chunks->reach;
    return x == entry->x && y == entry->y && covered ? TUFF_OK : TUFF_FAULT_INDEX_MOVED;
}

static tuff_fault check_index(const tuff_world *world, uint16_t *piece)
{
    const tuff_chunks *chunks = world->chunks;
    uint16_t count = world->terrain_count > chunks->capacity ? world->terrain_count : chunks->capacity;
    tuff_fault fault = check_storage(chunks);
    uint16_t i;
    for (i = 0; chunks->used && i < count && fault == TUFF_OK; ++i) {
        *piece = i;
        fault = check_entry(chunks, i, i < world->terrain_count ? &world->terrain[i] : NULL);
    }
    return fault;
}

static tuff_fault check_world(const tuff_world *world, uint16_t *piece)
{
    uint16_t i;
    if (world == NULL || (world->terrain == NULL && world->terrain_count > 0)) return TUFF_FAULT_NULL;
    if (world->nearby == NULL && world->nearby_capacity > 0) return TUFF_FAULT_NULL;
    if (world->terrain_count > TUFF_MAX_PIECES) return TUFF_FAULT_TERRAIN_COUNT;
    if (world->order != TUFF_ORDER_ITERATION && world->order != TUFF_ORDER_DEEPEST) return TUFF_FAULT_ORDER;
    for (i = 0; i < world->terrain_count; ++i) {
        tuff_fault fault = tuff_check_terrain(&world->terrain[i]);
        *piece = i;
        if (fault != TUFF_OK) return fault;
    }
    *piece = 0;
    return world->chunks == NULL ? TUFF_OK : check_index(world, piece);
}

tuff_fault tuff_check_world(const tuff_world *world, uint16_t *piece)
{
    uint16_t at = 0;
    tuff_fault fault = check_world(world, &at);
    if (piece != NULL) *piece = fault == TUFF_OK ? 0 : at;
    return fault;
}
