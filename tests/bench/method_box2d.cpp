/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Box2D's narrow phase: shapes and transforms are made beforehand, the polygon's skin (m_radius) is 0. Its ray casts do not report a
   segment that starts inside, by design; such answers count as wrong. */
#include "bench.h"

#include <box2d/box2d.h>

#include "box2d_shim.h"

namespace {

struct mover {
    b2Vec2 a, b;
    b2Transform at;
    b2CircleShape circle;
    const b2PolygonShape *hull, *polygon;
};

b2PolygonShape polygons[BENCH_SHAPES], hulls[BENCH_HULLS];
box2d_polygon *judged[BENCH_SHAPES], *judged_hulls[BENCH_HULLS];
mover movers[BENCH_PAIRS];
const bench_pair *pairs;

float real(int32_t raw)
{
    return static_cast<float>(raw) / BENCH_ONE;
}

b2Vec2 vec(bench_point p)
{
    return b2Vec2(real(p.x), real(p.y));
}

box2d_vec shim_vec(bench_point p)
{
    return box2d_vec{ real(p.x), real(p.y) };
}

void read_shape(const bench_shape &shape, b2PolygonShape *polygon, box2d_polygon **same)
{
    b2Vec2 points[b2_maxPolygonVertices];
    box2d_vec shim_points[b2_maxPolygonVertices];
    if (*same) box2d_polygon_free(*same);
    *same = nullptr;
    if (shape.count > b2_maxPolygonVertices) return;
    for (int i = 0; i < shape.count; i++) {
        points[i] = vec(shape.vertices[i]);
        shim_points[i] = shim_vec(shape.vertices[i]);
    }
    polygon->Set(points, shape.count);
    polygon->m_radius = 0.0f;
    *same = box2d_polygon_new(shim_points, shape.count);
}

void prepare(const bench_set *set)
{
    for (int i = 0; i < BENCH_SHAPES; i++) read_shape(set->shapes[i], &polygons[i], &judged[i]);
    for (int i = 0; i < BENCH_HULLS; i++) read_shape(set->hulls[i], &hulls[i], &judged_hulls[i]);
    for (uint32_t i = 0; i < set->count; i++) {
        const bench_pair &pair = set->pairs[i];
        mover &m = movers[i];
        m.a = vec(pair.a);
        m.b = vec(pair.b);
        m.at.Set(m.a, 0.0f);
        m.circle.m_radius = real(pair.radius);
        m.hull = &hulls[pair.hull];
        m.polygon = &polygons[pair.shape];
    }
    pairs = set->pairs;
}

uint32_t run_circles(const uint16_t *order, uint32_t count, const b2Transform &origin)
{
    uint32_t hits = 0;
    b2Manifold manifold;
    for (uint32_t i = 0; i < count; i++) {
        const mover &m = movers[order[i]];
        b2CollidePolygonAndCircle(&manifold, m.polygon, origin, &m.circle, m.at);
        hits += manifold.pointCount > 0;
    }
    return hits;
}

uint32_t run_hulls(const uint16_t *order, uint32_t count, const b2Transform &origin)
{
    uint32_t hits = 0;
    b2Manifold manifold;
    for (uint32_t i = 0; i < count; i++) {
        const mover &m = movers[order[i]];
        b2CollidePolygons(&manifold, m.polygon, origin, m.hull, m.at);
        hits += manifold.pointCount > 0;
    }
    return hits;
}

uint32_t run_segments(const uint16_t *order, uint32_t count, const b2Transform &origin)
{
    uint32_t hits = 0;
    b2RayCastOutput output;
    for (uint32_t i = 0; i < count; i++) {
        const mover &m = movers[order[i]];
        b2RayCastInput input = { m.a, m.b, 1.0f };
        hits += m.polygon->b2PolygonShape::RayCast(&output, input, origin, 0);
    }
    return hits;
}

uint32_t run(int what, const uint16_t *order, uint32_t count)
{
    b2Transform origin;
    origin.SetIdentity();
    if (what == BENCH_CIRCLE) return run_circles(order, count, origin);
    if (what == BENCH_HULL) return run_hulls(order, count, origin);
    return run_segments(order, count, origin);
}

void answer(bench_kind kind, uint32_t number, bench_answer *out)
{
    const bench_pair &pair = pairs[number];
    const box2d_polygon *polygon = judged[pair.shape];
    const box2d_vec origin = { 0.0f, 0.0f };
    box2d_contact contact = { 0.0f, { 0.0f, 0.0f } };
    box2d_hit hit;
    if (kind == BENCH_CIRCLE) {
        out->hit = box2d_circle_polygon(polygon, origin, shim_vec(pair.a), real(pair.radius), &contact);
    } else if (kind == BENCH_HULL) {
        out->hit = box2d_hull_polygon(polygon, origin, judged_hulls[pair.hull], shim_vec(pair.a), &contact);
    } else {
        out->hit = box2d_ray_polygon(polygon, origin, shim_vec(pair.a), shim_vec(pair.b), &hit);
    }
    out->depth = static_cast<double>(contact.overlap);
}

double bytes(int)
{
    return sizeof(b2PolygonShape);
}

}

extern "C" const bench_method bench_box2d = { "box2d", "float", b2_maxPolygonVertices, prepare, run, answer, bytes };
