/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Box2D behind a C interface. Manifolds are evaluated in the obstacle's frame, where Box2D keeps its digits far from the origin. */
#include "box2d_shim.h"

#include <vector>

#include <box2d/box2d.h>

struct box2d_polygon { b2PolygonShape shape; };

struct box2d_world {
    b2World world;
    std::vector<b2Body *> balls;
    box2d_world() : world(b2Vec2(0.0f, 0.0f)) {}
};

static b2Transform placed(box2d_vec at)
{
    return b2Transform(b2Vec2(at.x, at.y), b2Rot(0.0f));
}

static b2CircleShape circle_of(float radius)
{
    b2CircleShape circle;
    circle.m_radius = radius;
    return circle;
}

box2d_polygon *box2d_polygon_new(const box2d_vec *vertices, int count)
{
    b2Vec2 points[b2_maxPolygonVertices];
    box2d_polygon *polygon = new box2d_polygon;
    for (int i = 0; i < count; i++) points[i].Set(vertices[i].x, vertices[i].y);
    polygon->shape.Set(points, count);
    polygon->shape.m_radius = 0.0f;
    if (polygon->shape.m_count == count) return polygon;
    delete polygon;
    return nullptr;
}

void box2d_polygon_free(box2d_polygon *polygon)
{
    delete polygon;
}

static bool deepest(const b2Manifold &manifold, float radius, const b2Transform &relative, box2d_contact *contact)
{
    b2WorldManifold in_frame;
    if (manifold.pointCount == 0) return false;
    in_frame.Initialize(&manifold, b2Transform(b2Vec2(0.0f, 0.0f), b2Rot(0.0f)), 0.0f, relative, radius);
    contact->overlap = -in_frame.separations[0];
    if (manifold.pointCount > 1) contact->overlap = b2Max(contact->overlap, -in_frame.separations[1]);
    contact->normal = box2d_vec{ in_frame.normal.x, in_frame.normal.y };
    return true;
}

bool box2d_circle_polygon(const box2d_polygon *polygon, box2d_vec at, box2d_vec center, float radius, box2d_contact *contact)
{
    b2Manifold manifold;
    b2CircleShape circle = circle_of(radius);
    b2CollidePolygonAndCircle(&manifold, &polygon->shape, placed(at), &circle, placed(center));
    return deepest(manifold, radius, b2MulT(placed(at), placed(center)), contact);
}

bool box2d_hull_polygon(const box2d_polygon *polygon, box2d_vec at, const box2d_polygon *hull, box2d_vec position, box2d_contact *contact)
{
    b2Manifold manifold;
    b2CollidePolygons(&manifold, &polygon->shape, placed(at), &hull->shape, placed(position));
    return deepest(manifold, 0.0f, b2MulT(placed(at), placed(position)), contact);
}

bool box2d_circle_touches(const box2d_polygon *polygon, box2d_vec at, box2d_vec center, float radius)
{
    b2CircleShape circle = circle_of(radius);
    return b2TestOverlap(&polygon->shape, 0, &circle, 0, placed(at), placed(center));
}

bool box2d_hull_touches(const box2d_polygon *polygon, box2d_vec at, const box2d_polygon *hull, box2d_vec position)
{
    return b2TestOverlap(&polygon->shape, 0, &hull->shape, 0, placed(at), placed(position));
}

static bool cast(const b2Shape &shape, box2d_vec at, box2d_vec a, box2d_vec b, box2d_hit *hit)
{
    b2RayCastInput input;
    b2RayCastOutput output;
    input.p1.Set(a.x, a.y);
    input.p2.Set(b.x, b.y);
    input.maxFraction = 1.0f;
    if (!shape.RayCast(&output, input, placed(at), 0)) return false;
    *hit = box2d_hit{ output.fraction, { output.normal.x, output.normal.y } };
    return true;
}

bool box2d_ray_polygon(const box2d_polygon *polygon, box2d_vec at, box2d_vec a, box2d_vec b, box2d_hit *hit)
{
    return cast(polygon->shape, at, a, b, hit);
}

bool box2d_ray_circle(float radius, box2d_vec at, box2d_vec a, box2d_vec b, box2d_hit *hit)
{
    return cast(circle_of(radius), at, a, b, hit);
}

box2d_world *box2d_world_new(void)
{
    box2d_world *world = new box2d_world;
    world->world.SetContinuousPhysics(false);
    world->world.SetAllowSleeping(false);
    return world;
}

void box2d_world_free(box2d_world *world)
{
    delete world;
}

void box2d_world_add_rock(box2d_world *world, const box2d_polygon *polygon, box2d_vec at)
{
    b2BodyDef body;
    b2FixtureDef fixture;
    body.position.Set(at.x, at.y);
    fixture.shape = &polygon->shape;
    fixture.friction = 0.0f;
    world->world.CreateBody(&body)->CreateFixture(&fixture);
}

int box2d_world_add_ball(box2d_world *world, box2d_vec position, box2d_vec velocity, float radius, float restitution)
{
    b2CircleShape circle = circle_of(radius);
    b2BodyDef body;
    b2FixtureDef fixture;
    body.type = b2_dynamicBody;
    body.fixedRotation = true;
    body.position.Set(position.x, position.y);
    body.linearVelocity.Set(velocity.x, velocity.y);
    fixture.shape = &circle;
    fixture.density = 1.0f;
    fixture.friction = 0.0f;
    fixture.restitution = restitution;
    fixture.restitutionThreshold = 0.0f;
    fixture.filter.groupIndex = -1;
    world->balls.push_back(world->world.CreateBody(&body));
    world->balls.back()->CreateFixture(&fixture);
    return static_cast<int>(world->balls.size()) - 1;
}

void box2d_world_step(box2d_world *world, float seconds)
{
    world->world.Step(seconds, 8, 3);
}

void box2d_world_ball(const box2d_world *world, int ball, box2d_vec *position, box2d_vec *velocity)
{
    const b2Body *body = world->balls[static_cast<std::size_t>(ball)];
    *position = box2d_vec{ body->GetPosition().x, body->GetPosition().y };
    *velocity = box2d_vec{ body->GetLinearVelocity().x, body->GetLinearVelocity().y };
}
