/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   A walled belt of fixed asteroids full of bouncing balls, run by tuff and by Box2D from the same start, without friction. Paths are
   compared ball by ball until they part: the two push differently out of an overlap (tuff at once, Box2D a fifth a step), and each corner
   multiplies the difference. */
#include "twin.h"

#define ROCKS   36                  /* 6 rows and columns, 24 units apart */
#define PIECES  (ROCKS + 4)         /* and four walls */
#define BALLS   48
#define STEPS   6000
#define STEPS_A_SECOND 512
#define PARTED  (EXACT_UNIT / 10.0)

typedef struct belt {
    twin         rocks[ROCKS], walls[4];
    tuff_terrain pieces[PIECES];
    tuff_world   world;
    tuff_chunks  chunks;
    box2d_world *box;
} belt;

typedef struct ball {
    tuff_body body;
    tuff_real radius;
    double    speed;                /* at the start, steps */
    int       bounces, agreed;      /* agreed: bounces before the paths parted */
    int       parted, first;        /* the steps at which they did, and of the first bounce; 0: not yet */
    double    turned;               /* how far the velocities differ after the first bounce, as a share of the speed */
} ball;

static uint16_t buckets[64];
static tuff_chunk_entry entries[PIECES];

/* ---- the belt ---- */

static void add_piece(belt *b, int i, const twin *t, double x, double y)
{
    tuff_vec2 at = { twin_real(x * EXACT_UNIT), twin_real(y * EXACT_UNIT) };
    b->pieces[i] = (tuff_terrain){ at, 0, t->shape.bounding_radius, &t->shape.polygon, 1 };
    box2d_world_add_rock(b->box, t->box, twin_vec(at));
}

static void make_wall(twin *t, double half_width, double half_height)
{
    box2d_vec vertices[4];
    random_box_shape(&t->shape, random_point_at(half_width, half_height));
    for (int i = 0; i < 4; i++) vertices[i] = twin_vec(t->shape.vertices[i]);
    t->box = box2d_polygon_new(vertices, 4);
}

static void make_belt(random_source *source, belt *b)
{
    b->box = box2d_world_new();
    for (int i = 0; i < ROCKS; i++) {
        twin_make(source, &b->rocks[i], random_within(source, 3, 8));
        double x = i % 6 * 24 - 60 + random_within(source, -2, 2);
        add_piece(b, i, &b->rocks[i], x, i / 6 * 24 - 60 + random_within(source, -2, 2));
    }
    for (int i = 0; i < 4; i++) {
        make_wall(&b->walls[i], i < 2 ? 80 : 4, i < 2 ? 4 : 80);
        add_piece(b, ROCKS + i, &b->walls[i], i == 2 ? -80 : i == 3 ? 80 : 0, i == 0 ? -80 : i == 1 ? 80 : 0);
    }
    b->chunks = (tuff_chunks)TUFF_CHUNKS(buckets, entries, 5);
    b->world = (tuff_world){ b->pieces, PIECES, &b->chunks, NULL, 0, TUFF_ORDER_ITERATION };
    assert_int_equal(tuff_world_index(&b->world), 0);
}

static void free_belt(belt *b)
{
    box2d_world_free(b->box);
    for (int i = 0; i < ROCKS; i++) twin_free(&b->rocks[i]);
    for (int i = 0; i < 4; i++) twin_free(&b->walls[i]);
}

/* ---- the balls ---- */

static bool is_free(const belt *b, tuff_vec2 position, tuff_real radius)
{
    tuff_contact contact;
    for (int i = 0; i < PIECES; i++) {
        if (tuff_terrain_overlap_circle(&b->pieces[i], position, radius + TUFF_WHOLE(1), &contact)) return false;
    }
    return true;
}

/* 8 to 16 units a second: slow enough a step that pushes are small. */
static void make_ball(random_source *source, belt *b, ball *one, const tuff_material *material)
{
    double angle = random_within(source, 0, 6.283185307179586), speed = random_within(source, 8, 16) / STEPS_A_SECOND;
    one->radius = twin_real(EXACT_UNIT * random_within(source, 0.5, 2));
    one->body.material = material;
    one->body.velocity.x = TUFF_REAL_RAW((int32_t)(speed * cos(angle) * EXACT_UNIT));
    one->body.velocity.y = TUFF_REAL_RAW((int32_t)(speed * sin(angle) * EXACT_UNIT));
    one->speed = (double)exact_length(exact_vec2(one->body.velocity));
    do {
        one->body.position.x = twin_real(EXACT_UNIT * random_within(source, -70, 70));
        one->body.position.y = twin_real(EXACT_UNIT * random_within(source, -70, 70));
    } while (!is_free(b, one->body.position, one->radius));
    box2d_vec velocity = twin_vec(one->body.velocity);
    velocity = (box2d_vec){ velocity.x * STEPS_A_SECOND, velocity.y * STEPS_A_SECOND };
    box2d_world_add_ball(b->box, twin_vec(one->body.position), velocity, tuff_to_float(one->radius), tuff_to_float(material->restitution));
}

/* Box2D finds an overlap a step later than tuff; two steps after the first bounce both have turned. */
static void compare_velocities(ball *one, box2d_vec velocity)
{
    const exact scale = (exact)EXACT_UNIT / STEPS_A_SECOND;
    exact2 ours = exact_vec2(one->body.velocity), box = { (exact)velocity.x * scale, (exact)velocity.y * scale };
    if (one->bounces == 1) one->turned = (double)exact_length(exact_sub(ours, box)) / one->speed;
}

static void compare_paths(const belt *b, ball *one, int index, int step)
{
    box2d_vec position, velocity;
    box2d_world_ball(b->box, index, &position, &velocity);
    if (one->first && step == one->first + 2) compare_velocities(one, velocity);
    exact2 box = { (exact)position.x * EXACT_UNIT, (exact)position.y * EXACT_UNIT };
    exact2 apart = exact_sub(box, exact_vec2(one->body.position));
    if ((double)exact_length(apart) > PARTED) one->parted = step;
    else one->agreed = one->bounces;
}

static void step_belt(belt *b, ball *balls, int step)
{
    box2d_world_step(b->box, 1.0f / STEPS_A_SECOND);
    for (int i = 0; i < BALLS; i++) {
        tuff_body *body = &balls[i].body;
        body->position.x += body->velocity.x;
        body->position.y += body->velocity.y;
        if (tuff_terrain_collide_circle(&b->world, body, balls[i].radius) && balls[i].bounces++ == 0) balls[i].first = step;
        if (balls[i].parted == 0) compare_paths(b, &balls[i], i, step);
    }
}

/* ---- what must hold; NULL: it does ---- */

static const char *someone_inside(const belt *b, const ball *one)
{
    tuff_contact contact = { 0, { 0, 0 } };
    for (int k = 0; k < PIECES; k++) {
        bool inside = tuff_terrain_overlap_circle(&b->pieces[k], one->body.position, one->radius, &contact);
        if (inside && contact.overlap > TUFF_RATIO(1, 1000)) return "a ball was left inside a rock";
    }
    return NULL;
}

/* Without friction a bounce of restitution 1 keeps the speed, rounding aside, and the fixed build never adds any. */
static const char *speed_changed(const ball *one)
{
    double speed = (double)exact_length(exact_vec2(one->body.velocity));
    if (one->body.material->restitution != TUFF_WHOLE(1)) return NULL;
    if (speed > one->speed * (EXACT_WHOLE ? 1 : 1.0001)) return "a ball gained speed";
    return speed < one->speed * 0.9999 - 2 * one->bounces ? "a ball lost speed" : NULL;
}

/* The first bounce comes from equal paths: it must not part them, nor may they part before it. */
static const char *path_wrong(const ball *one)
{
    if (one->parted && (one->first == 0 || one->parted <= one->first + 2)) return "paths part before or at the first bounce";
    return one->turned > 0.01 ? "velocities differ after the first bounce" : NULL;
}

static const char *fault_of(const belt *b, const ball *balls)
{
    int bounced = 0, agreed = 0;
    for (int i = 0; i < BALLS; i++) {
        const char *inside = someone_inside(b, &balls[i]), *speed = speed_changed(&balls[i]), *path = path_wrong(&balls[i]);
        if (inside || speed || path) return inside ? inside : speed ? speed : path;
        bounced += balls[i].bounces > 0;
        agreed += balls[i].agreed;
    }
    return agreed < 2 * bounced ? "fewer than two bounces a ball agree" : NULL;
}

static void print_belt(const ball *balls, const char *what)
{
    int first = STEPS, together = 0, bounces = 0, agreed = 0;
    double turned = 0;
    for (int i = 0; i < BALLS; i++) {
        if (balls[i].parted && balls[i].parted < first) first = balls[i].parted;
        together += balls[i].parted == 0;
        bounces += balls[i].bounces;
        agreed += balls[i].agreed;
        raise_to(&turned, (exact)balls[i].turned);
    }
    printf("figures: belt, %s, tuff %s: %d balls, %d steps, %d bounces; paths within 0.1 unit of Box2D's to step %d, %d balls to the end; "
           "bounces agreed: %d; velocities after first bounces differ by %.2g of the speed at most\n", what, EXACT_BUILD, BALLS, STEPS,
           bounces, first, together, agreed, turned);
}

static void run_belt(const char *name, const char *what, tuff_material material)
{
    random_run run = random_cases(name, 701, 1);
    random_source source = random_stream(run.seed, run.first);
    static belt b;
    static ball balls[BALLS];
    make_belt(&source, &b);
    for (int i = 0; i < BALLS; i++) {
        balls[i] = (ball){ { { 0, 0 }, { 0, 0 }, NULL }, 0, 0, 0, 0, 0, 0, 0 };
        make_ball(&source, &b, &balls[i], &material);
    }
    for (int step = 1; step <= STEPS; step++) step_belt(&b, balls, step);
    print_belt(balls, what);
    const char *fault = fault_of(&b, balls);
    free_belt(&b);
    if (fault) random_fail(&run, run.first, "%s", fault);
}

static void belt_without_loss_as_in_box2d(void **state)
{
    (void)state;
    run_belt(__func__, "restitution 1", (tuff_material){ TUFF_WHOLE(1), 0 });
}

static void belt_with_loss_as_in_box2d(void **state)
{
    (void)state;
    run_belt(__func__, "restitution 0.9", (tuff_material){ TUFF_RATIO(9, 10), 0 });
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(belt_without_loss_as_in_box2d),
        cmocka_unit_test(belt_with_loss_as_in_box2d),
    };
    (void)argc;
    random_begin(argv);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
