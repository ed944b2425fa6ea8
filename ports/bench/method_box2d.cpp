/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Box2D's narrow phase, one pair at a time; polygons of up to 8 vertices, their skin (m_radius) 0. */
#include <new>

#include <box2d/b2_circle_shape.h>
#include <box2d/b2_collision.h>
#include <box2d/b2_polygon_shape.h>

#include "count.h"
#include "method.h"

namespace {

/* Made in place: nobody calls constructors before main on a machine without an operating system. */
alignas(b2PolygonShape) unsigned char places[2][sizeof(b2PolygonShape)];
b2PolygonShape *polygon, *hull;

b2Vec2 vec(bench_point p)
{
    return b2Vec2(static_cast<float>(p.x) / BENCH_ONE, static_cast<float>(p.y) / BENCH_ONE);
}

b2Transform placed(bench_point at)
{
    b2Transform transform;
    transform.Set(vec(at), 0.0f);
    return transform;
}

b2PolygonShape *read_shape(int slot, const bench_shape *shape)
{
    b2PolygonShape *out = new (places[slot]) b2PolygonShape;
    b2Vec2 points[b2_maxPolygonVertices];
    for (int i = 0; i < shape->count; i++) points[i] = vec(shape->vertices[i]);
    out->Set(points, shape->count);
    out->m_radius = 0.0f;
    return out;
}

bool count_circle(const b2Transform &origin, const sets_pair *pair)
{
    b2Transform at = placed(pair->a);
    b2CircleShape circle;
    b2Manifold manifold;
    circle.m_radius = static_cast<float>(pair->radius) / BENCH_ONE;
    count_begin();
    b2CollidePolygonAndCircle(&manifold, polygon, origin, &circle, at);
    count_end();
    return manifold.pointCount > 0;
}

bool count_hull(const b2Transform &origin, const sets_pair *pair)
{
    b2Transform at = placed(pair->a);
    b2Manifold manifold;
    count_begin();
    b2CollidePolygons(&manifold, polygon, origin, hull, at);
    count_end();
    return manifold.pointCount > 0;
}

bool count_segment(const b2Transform &origin, const sets_pair *pair)
{
    b2RayCastOutput output;
    b2RayCastInput input = { vec(pair->a), vec(pair->b), 1.0f };
    count_begin();
    bool hit = polygon->b2PolygonShape::RayCast(&output, input, origin, 0);
    count_end();
    return hit;
}

}

extern "C" const int method_max_vertices = b2_maxPolygonVertices;

extern "C" void method_load(const bench_shape *polygon_shape, const bench_shape *hull_shape)
{
    polygon = read_shape(0, polygon_shape);
    hull = read_shape(1, hull_shape);
}

extern "C" bool method_count(bench_kind kind, const sets_pair *pair)
{
    b2Transform origin;
    origin.SetIdentity();
    if (kind == BENCH_CIRCLE) return count_circle(origin, pair);
    if (kind == BENCH_HULL) return count_hull(origin, pair);
    return count_segment(origin, pair);
}
