/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Box2D's world behind the yardstick. */
#include "yardstick.h"

#include <vector>

#include <box2d/box2d.h>

static const double units_per_meter = 32.0, steps_per_second = 60.0;
static const int velocity_rounds = 8, position_rounds = 3;    /* Box2D's advice */

struct yardstick {
    b2World world;
    std::vector<b2Body *> bodies;
    uintptr_t terrain_count = 0;
    explicit yardstick(const b2Vec2 &gravity) : world(gravity) {}
};

static b2Vec2 meters(yardstick_vec v)
{
    return b2Vec2(static_cast<float>(v.x / units_per_meter), static_cast<float>(v.y / units_per_meter));
}

static b2Vec2 meters_per_second(yardstick_vec v)
{
    return b2Vec2(static_cast<float>(v.x * steps_per_second / units_per_meter),
                  static_cast<float>(v.y * steps_per_second / units_per_meter));
}

yardstick *yardstick_new(yardstick_vec gravity, bool continuous)
{
    double scale = steps_per_second * steps_per_second / units_per_meter;
    yardstick *yard = new yardstick(b2Vec2(static_cast<float>(gravity.x * scale), static_cast<float>(gravity.y * scale)));
    yard->world.SetContinuousPhysics(continuous);
    yard->world.SetAllowSleeping(false);
    return yard;
}

void yardstick_free(yardstick *yard)
{
    delete yard;
}

/* ---- shapes ---- */

/* Box2D welds points nearer than half of its slop, and aborts the program if fewer than three are left. */
static bool would_weld(const b2Vec2 *points, int count)
{
    const float nearest = 0.5f * b2_linearSlop;
    for (int i = 0; i < count; i++) {
        for (int j = 0; j < i; j++) {
            if (b2DistanceSquared(points[i], points[j]) < nearest * nearest) return true;
        }
    }
    return false;
}

static bool polygon_of(b2PolygonShape *shape, const yardstick_vec *vertices, int count)
{
    b2Vec2 points[YARDSTICK_VERTICES];
    if (count < 3 || count > YARDSTICK_VERTICES) return false;
    for (int i = 0; i < count; i++) points[i] = meters(vertices[i]);
    if (would_weld(points, count)) return false;
    shape->Set(points, count);
    return shape->m_count == count;
}

static b2CircleShape circle_of(double radius)
{
    b2CircleShape shape;
    shape.m_radius = static_cast<float>(radius / units_per_meter);
    return shape;
}

static void add_terrain(yardstick *yard, yardstick_vec at, const b2Shape &shape, double friction)
{
    b2BodyDef body;
    b2FixtureDef fixture;
    body.position = meters(at);
    body.userData.pointer = yard->terrain_count++;
    fixture.shape = &shape;
    fixture.friction = static_cast<float>(friction);
    yard->world.CreateBody(&body)->CreateFixture(&fixture);
}

bool yardstick_add_polygon(yardstick *yard, yardstick_vec at, const yardstick_vec *vertices, int count, double friction)
{
    b2PolygonShape shape;
    if (!polygon_of(&shape, vertices, count)) return false;
    add_terrain(yard, at, shape, friction);
    return true;
}

void yardstick_add_circle(yardstick *yard, yardstick_vec at, double radius, double friction)
{
    add_terrain(yard, at, circle_of(radius), friction);
}

void yardstick_add_chain(yardstick *yard, const yardstick_vec *points, int count, double friction)
{
    std::vector<b2Vec2> line;
    b2ChainShape chain;
    for (int i = 0; i < count; i++) line.push_back(meters(points[i]));
    b2Vec2 before = line[0] - (line[1] - line[0]), after = line.back() + (line.back() - line[line.size() - 2]);
    chain.CreateChain(line.data(), count, before, after);
    add_terrain(yard, yardstick_vec{ 0.0, 0.0 }, chain, friction);
}

namespace {

struct collector : b2QueryCallback {
    int *found, room, count = 0;
    collector(int *list, int most) : found(list), room(most) {}
    bool ReportFixture(b2Fixture *fixture) override
    {
        if (fixture->GetBody()->GetType() != b2_staticBody) return true;
        if (count < room) found[count] = static_cast<int>(fixture->GetBody()->GetUserData().pointer);
        count++;
        return true;
    }
};

}

int yardstick_query(const yardstick *yard, yardstick_vec low, yardstick_vec high, int *found, int room)
{
    b2AABB box;
    collector list(found, room);
    box.lowerBound = meters(low);
    box.upperBound = meters(high);
    yard->world.QueryAABB(&list, box);
    return list.count;
}

/* ---- bodies ---- */

static int add_body(yardstick *yard, const yardstick_state &state, const b2Shape &shape, const yardstick_material &material)
{
    b2BodyDef body;
    b2FixtureDef fixture;
    body.type = b2_dynamicBody;
    body.fixedRotation = true;
    body.position = meters(state.position);
    body.linearVelocity = meters_per_second(state.velocity);
    fixture.shape = &shape;
    fixture.density = 1.0f;
    fixture.friction = static_cast<float>(material.friction);
    fixture.restitution = static_cast<float>(material.restitution);
    fixture.restitutionThreshold = 0.0f;
    fixture.filter.groupIndex = -1;
    yard->bodies.push_back(yard->world.CreateBody(&body));
    yard->bodies.back()->CreateFixture(&fixture);
    return static_cast<int>(yard->bodies.size()) - 1;
}

int yardstick_add_ball(yardstick *yard, yardstick_state state, double radius, yardstick_material material)
{
    return add_body(yard, state, circle_of(radius), material);
}

int yardstick_add_hull(yardstick *yard, yardstick_state state, const yardstick_vec *vertices, int count, yardstick_material material)
{
    b2PolygonShape shape;
    return polygon_of(&shape, vertices, count) ? add_body(yard, state, shape, material) : -1;
}

void yardstick_step(yardstick *yard)
{
    yard->world.Step(static_cast<float>(1.0 / steps_per_second), velocity_rounds, position_rounds);
}

static yardstick_vec units(const b2Vec2 &v, double scale)
{
    return yardstick_vec{ v.x * scale, v.y * scale };
}

yardstick_state yardstick_body(const yardstick *yard, int body)
{
    const b2Body *b = yard->bodies[static_cast<std::size_t>(body)];
    return yardstick_state{ units(b->GetPosition(), units_per_meter), units(b->GetLinearVelocity(), units_per_meter / steps_per_second) };
}

void yardstick_set(yardstick *yard, int body, yardstick_state state)
{
    b2Body *b = yard->bodies[static_cast<std::size_t>(body)];
    b->SetTransform(meters(state.position), 0.0f);
    b->SetLinearVelocity(meters_per_second(state.velocity));
}
