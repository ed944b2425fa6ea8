/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   A frame of the scene by Box2D's parts: its dynamic tree says which pieces' boxes are touched, its narrow phase tests them, and the
   body is pushed and bounced as tuff does it. A beam stops at any piece, as tuff's does, not at the nearest. */
#include "bench.h"

#include <box2d/box2d.h>

namespace {

struct body { b2Vec2 position, velocity; };
struct calls { body bodies[BENCH_BODIES]; b2Vec2 beams[BENCH_BEAMS][2]; };

b2PolygonShape octagons[BENCH_OCTAGONS], hull;
const b2PolygonShape *polygons[BENCH_PIECES];
b2Transform places[BENCH_PIECES];
b2CircleShape circles[BENCH_BODIES];
calls frames[BENCH_FRAMES];
b2DynamicTree *tree;

float real(int32_t raw)
{
    return static_cast<float>(raw) / BENCH_ONE;
}

b2Vec2 vec(bench_point p)
{
    return b2Vec2(real(p.x), real(p.y));
}

void read_shape(const bench_shape &shape, b2PolygonShape *polygon)
{
    b2Vec2 points[b2_maxPolygonVertices];
    for (int i = 0; i < shape.count; i++) points[i] = vec(shape.vertices[i]);
    polygon->Set(points, shape.count);
    polygon->m_radius = 0.0f;
}

void read_frame(calls *out, const bench_frame &frame)
{
    for (int i = 0; i < BENCH_BODIES; i++) out->bodies[i] = body{ vec(frame.bodies[i].position), vec(frame.bodies[i].velocity) };
    for (int i = 0; i < BENCH_BEAMS * 2; i++) out->beams[i / 2][i % 2] = vec(frame.beams[i / 2][i % 2]);
}

void prepare(const bench_scene *scene)
{
    delete tree;
    tree = new b2DynamicTree;
    for (int i = 0; i < BENCH_OCTAGONS; i++) read_shape(scene->octagons[i], &octagons[i]);
    read_shape(scene->hull, &hull);
    for (intptr_t i = 0; i < BENCH_PIECES; i++) {
        b2AABB box;
        places[i].Set(vec(scene->pieces[i].position), 0.0f);
        polygons[i] = &octagons[scene->pieces[i].shape];
        polygons[i]->ComputeAABB(&box, places[i], 0);
        tree->CreateProxy(box, reinterpret_cast<void *>(i));
    }
    for (int i = 0; i < BENCH_BODIES; i++) circles[i].m_radius = real(bench_body_radius(i));
    for (int i = 0; i < BENCH_FRAMES; i++) read_frame(&frames[i], scene->frames[i]);
}

intptr_t piece_of(int32_t proxy)
{
    return reinterpret_cast<intptr_t>(tree->GetUserData(proxy));
}

void bounce(body *moving, const b2Vec2 &normal, float depth)
{
    float speed = b2Dot(moving->velocity, normal);
    moving->position += depth * normal;
    if (speed >= 0.0f) return;
    moving->velocity = -0.09f * speed * normal + 0.99f * (moving->velocity - speed * normal);
}

struct collision {
    body moving;
    const b2CircleShape *circle;    // null: the hull
    b2Transform at;
    uint32_t pushes;

    bool QueryCallback(int32_t proxy)
    {
        intptr_t piece = piece_of(proxy);
        b2Manifold manifold;
        b2WorldManifold contact;
        at.p = moving.position;
        if (circle) b2CollidePolygonAndCircle(&manifold, polygons[piece], places[piece], circle, at);
        else b2CollidePolygons(&manifold, polygons[piece], places[piece], &hull, at);
        if (manifold.pointCount == 0) return true;
        contact.Initialize(&manifold, places[piece], 0.0f, at, circle ? circle->m_radius : 0.0f);
        float separation = contact.separations[0];
        if (manifold.pointCount > 1) separation = b2Min(separation, contact.separations[1]);
        bounce(&moving, contact.normal, -separation);
        pushes++;
        return true;
    }
};

struct beam {
    bool stopped;

    float RayCastCallback(const b2RayCastInput &input, int32_t proxy)
    {
        intptr_t piece = piece_of(proxy);
        b2RayCastOutput output;
        stopped = polygons[piece]->b2PolygonShape::RayCast(&output, input, places[piece], 0);
        return stopped ? 0.0f : input.maxFraction;
    }
};

uint32_t collide(const body &moving, int number)
{
    collision query = { moving, number == 0 ? nullptr : &circles[number], b2Transform(moving.position, b2Rot(0.0f)), 0 };
    b2Vec2 reach(circles[number].m_radius, circles[number].m_radius);
    b2AABB box;
    box.lowerBound = moving.position - reach;
    box.upperBound = moving.position + reach;
    tree->Query(&query, box);
    return query.pushes;
}

uint32_t run_frame(const calls &frame)
{
    uint32_t hits = 0;
    for (int i = 0; i < BENCH_BODIES; i++) hits += collide(frame.bodies[i], i);
    for (int i = 0; i < BENCH_BEAMS; i++) {
        beam query = { false };
        b2RayCastInput input = { frame.beams[i][0], frame.beams[i][1], 1.0f };
        tree->RayCast(&query, input);
        hits += query.stopped;
    }
    return hits;
}

uint32_t run(int, const uint16_t *order, uint32_t count)
{
    uint32_t hits = 0;
    for (uint32_t i = 0; i < count; i++) hits += run_frame(frames[order[i]]);
    return hits;
}

// A binary tree with a leaf for each piece.
uint32_t bytes()
{
    return sizeof octagons + sizeof polygons + sizeof places + (2 * BENCH_PIECES - 1) * sizeof(b2TreeNode);
}

}

extern "C" const bench_scene_method bench_box2d_scene = { "reference", "box2d", "float", prepare, run, bytes, 0 };
