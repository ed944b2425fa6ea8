/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Usage: bench-sets pairs COUNT VERTICES..., bench-sets scene. Writes inputs of the bench as C initializers, raw Q16.16, for the machines
   that cannot make them (ports/bench/sets.c): COUNT pairs of each class against polygons of so many vertices; or the reference scene, each
   step a frame. */
#include "adapt.h"
#include "sets.h"

#include <string.h>

typedef enum class_name { SEPARATED, FACE, VERTEX, HIT, OVERLAP, MISS, CLASSES } class_name;

static const char *const class_names[CLASSES] = { "separated", "face", "vertex", "hit", "overlap", "miss" };
static const char *const kind_names[BENCH_KINDS] = { "circle", "hull", "segment" };

/* The classes of each kind, in the order of the table. */
static const class_name classes[BENCH_KINDS][4] = {
    { SEPARATED, FACE, VERTEX, OVERLAP }, { SEPARATED, HIT, OVERLAP, CLASSES }, { MISS, HIT, CLASSES, CLASSES }
};

typedef struct model {
    tuff_vec2    vertices[BENCH_MAX_VERTICES];
    tuff_unit2   normals[BENCH_MAX_VERTICES];
    tuff_polygon polygon;
    tuff_real    bounding_radius;
} model;

static void read_model(model *m, const bench_shape *shape)
{
    adapt_pool pool = { m->vertices, m->normals, 0 };
    m->polygon = adapt_polygon(&pool, shape);
    m->bounding_radius = random_cover(m->vertices, shape->count);
}

static bool within(tuff_vec2 p, tuff_real radius)
{
    tuff_contact contact;
    return tuff_circle_circle(p, 0, radius, &contact);
}

static bool is_along_an_edge(const tuff_polygon *polygon, tuff_unit2 normal)
{
    for (int i = 0; i < polygon->count; i++) {
        if (memcmp(&polygon->normals[i], &normal, sizeof normal) == 0) return true;
    }
    return false;
}

/* Overlap is what has its center inside. Without contact only what the bounding circles let through counts: CLASSES is none. */
static class_name class_of_circle(const model *m, tuff_vec2 center, tuff_real radius)
{
    tuff_contact contact, inside;
    if (tuff_circle_polygon(center, 0, &m->polygon, &inside)) return OVERLAP;
    if (tuff_circle_polygon(center, radius, &m->polygon, &contact)) return is_along_an_edge(&m->polygon, contact.normal) ? FACE : VERTEX;
    return within(center, m->bounding_radius + radius) ? SEPARATED : CLASSES;
}

static class_name class_of_hull(const model *m, const model *hull, tuff_vec2 offset)
{
    tuff_contact contact;
    if (tuff_circle_polygon(offset, 0, &m->polygon, &contact)) return OVERLAP;
    if (tuff_polygon_polygon(&hull->polygon, offset, &m->polygon, &contact)) return HIT;
    return within(offset, m->bounding_radius + hull->bounding_radius) ? SEPARATED : CLASSES;
}

static class_name class_of_segment(const model *m, tuff_vec2 a, tuff_vec2 b)
{
    if (tuff_segment_polygon(a, b, &m->polygon)) return HIT;
    return tuff_segment_circle(a, b, m->bounding_radius) ? MISS : CLASSES;
}

static class_name class_of(const bench_set *set, const bench_pair *pair)
{
    model polygon, hull;
    read_model(&polygon, &set->shapes[pair->shape]);
    read_model(&hull, &set->hulls[pair->hull]);
    if (set->kind == BENCH_CIRCLE) return class_of_circle(&polygon, adapt_point(pair->a), pair->radius);
    if (set->kind == BENCH_HULL) return class_of_hull(&polygon, &hull, adapt_point(pair->a));
    return class_of_segment(&polygon, adapt_point(pair->a), adapt_point(pair->b));
}

/* The first ones of the set; rare classes reach those that were brought close to touching, for judging. */
static void write_class(const bench_set *set, class_name class, int size, uint32_t wanted)
{
    uint32_t found = 0;
    printf("{ \"%s,%d,%s\", %d, {\n", kind_names[set->kind], set->least, class_names[class], (int)set->kind);
    for (uint32_t i = 0; i < set->count && found < wanted; i++) {
        const bench_pair *p = &set->pairs[i];
        if (class_of(set, p) != class) continue;
        printf("{ { %d, %d }, { %d, %d }, %d, { %d, %d } },\n", p->a.x, p->a.y, p->b.x, p->b.y, p->radius,
               p->shape + size * BENCH_SHAPES, p->hull + size * BENCH_HULLS);
        found++;
    }
    printf("} },\n");
    if (found == wanted) return;
    fprintf(stderr, "bench-sets: only %u pairs %s %s\n", found, kind_names[set->kind], class_names[class]);
    exit(1);
}

static void write_shape(const bench_shape *shape)
{
    printf("{ {");
    for (int i = 0; i < shape->count; i++) printf(" { %d, %d },", shape->vertices[i].x, shape->vertices[i].y);
    printf(" }, %d },\n", shape->count);
}

static void write_shapes(const char *name, const bench_shape *shapes, int count)
{
    printf("static const bench_shape %s[] TABLE = {\n", name);
    for (int i = 0; i < count; i++) write_shape(&shapes[i]);
    printf("};\n");
}

#define MOST_SIZES 2

/* For one number of vertices the sets of all kinds have the same polygons and hulls; they are kept behind those of the sizes before. */
static void write_size(int size, int vertices, uint32_t wanted, bench_shape *shapes, bench_shape *hulls)
{
    static bench_set set;
    for (int kind = 0; kind < BENCH_KINDS; kind++) {
        bench_make_set(&set, (bench_kind)kind, vertices, vertices, BENCH_PAIRS);
        for (int i = 0; i < 4 && classes[kind][i] != CLASSES; i++) write_class(&set, classes[kind][i], size, wanted);
    }
    memcpy(shapes + size * BENCH_SHAPES, set.shapes, sizeof set.shapes);
    memcpy(hulls + size * BENCH_HULLS, set.hulls, sizeof set.hulls);
}

static int write_pairs(uint32_t wanted, int sizes, char **vertices)
{
    static bench_shape shapes[MOST_SIZES * BENCH_SHAPES], hulls[MOST_SIZES * BENCH_HULLS];
    printf("#define PAIRS %u\n", wanted);
    printf("static const struct { char name[SETS_NAME]; uint8_t kind; sets_pair pairs[PAIRS]; } cases[] TABLE = {\n");
    for (int i = 0; i < sizes; i++) write_size(i, atoi(vertices[i]), wanted, shapes, hulls);
    printf("};\n");
    write_shapes("shapes", shapes, sizes * BENCH_SHAPES);
    write_shapes("hulls", hulls, sizes * BENCH_HULLS);
    return 0;
}

static void write_points(const bench_point *points, int count)
{
    printf("{");
    for (int i = 0; i < count; i++) printf(" { %d, %d },", points[i].x, points[i].y);
    printf(" },\n");
}

static void write_frame(const bench_frame *frame)
{
    printf("{ {");
    for (int i = 0; i < BENCH_BODIES; i++) {
        const bench_body *b = &frame->bodies[i];
        printf(" { { %d, %d }, { %d, %d } },", b->position.x, b->position.y, b->velocity.x, b->velocity.y);
    }
    printf(" }, {");
    for (int i = 0; i < BENCH_BEAMS; i++) write_points(frame->beams[i], 2);
    printf("} },\n");
}

static int write_scene(void)
{
    static bench_scene scene;
    static bench_frame frames[BENCH_STEPS];
    bench_make_whole_scene(&scene, frames);
    write_shapes("octagons", scene.octagons, BENCH_OCTAGONS);
    write_shapes("hulls", &scene.hull, 1);
    printf("static const int32_t radii[] = {");
    for (int i = 0; i < BENCH_OCTAGONS; i++) printf(" %d,", scene.radii[i]);
    printf(" };\nstatic const bench_piece pieces[] = {\n");
    for (int i = 0; i < BENCH_PIECES; i++) {
        const bench_piece *p = &scene.pieces[i];
        printf("{ { %d, %d }, %d },\n", p->position.x, p->position.y, p->shape);
    }
    printf("};\nstatic const bench_frame frames[] = {\n");
    for (int i = 0; i < BENCH_STEPS; i++) write_frame(&frames[i]);
    printf("};\n");
    return 0;
}

int main(int argc, char **argv)
{
    if (argc == 2 && strcmp(argv[1], "scene") == 0) return write_scene();
    if (argc > 3 && argc <= 3 + MOST_SIZES && strcmp(argv[1], "pairs") == 0) {
        return write_pairs((uint32_t)atoi(argv[2]), argc - 3, argv + 3);
    }
    fprintf(stderr, "usage: bench-sets pairs COUNT VERTICES..., bench-sets scene\n");
    return 2;
}
