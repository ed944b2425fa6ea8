/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   What the parts of the bench share, free of any library's types: sets of inputs, the methods that answer them, and the measuring. */
#ifndef TUFF_BENCH_H
#define TUFF_BENCH_H

#include <stdbool.h>
#include <stdint.h>

#include "inputs.h"

#ifdef __cplusplus
extern "C" {
#endif

#define BENCH_SHAPES        36       /* polygons shared by the pairs of a set */
#define BENCH_HULLS         12
#define BENCH_PAIRS         3000     /* of a set, all of them judged ... */
#define BENCH_TIMED_PAIRS   600      /* ... and the first ones timed and counted; a third of each class */
#define BENCH_MAX_ITEMS     4096     /* of one measured run */

typedef enum bench_class { BENCH_OVERLAP, BENCH_NEAR, BENCH_FAR, BENCH_CLASSES, BENCH_ALL = BENCH_CLASSES } bench_class;

typedef struct bench_pair {         /* the polygon stands at the origin */
    bench_point a, b;               /* the circle's center, the hull's position, or the segment's ends */
    int32_t radius;
    uint8_t shape, hull;            /* numbers in the set */
    double  depth;                  /* the truth in units: how deep they overlap, or minus the distance between them */
} bench_pair;

typedef struct bench_set {
    bench_kind  kind;
    int         least, most;        /* vertices */
    uint32_t    count;
    bench_shape shapes[BENCH_SHAPES], hulls[BENCH_HULLS];
    bench_pair  pairs[BENCH_PAIRS]; /* pair i is of class i % BENCH_CLASSES */
} bench_set;

typedef struct bench_answer { bool hit; double depth; } bench_answer;    /* depth in units; of a segment 0 */

/* ---- measuring ---- */

/* Works through the items in this order and returns how many hit. One indirect call for all of them. */
typedef uint32_t bench_run(int what, const uint16_t *order, uint32_t count);

typedef struct bench_trial {
    char       key[64];             /* the columns of the CSV file that name it */
    bench_run *run;
    int        what;                /* passed to run */
    void     (*reset)(void);        /* before each run, not timed; NULL: nothing */
    double     ns;                  /* the result: median time of an item */
} bench_trial;

/* Counting, all calls of bench_measure leave the instructions to callgrind under the label `key count`, and no ns. */
void bench_begin(bool counting, unsigned steps);

/* Runs the trials on the same items, turn and turn about, the items in a new order each pass and the trials in another sequence; order
   is shuffled. progress names what is measured. */
void bench_measure(bench_trial *trials, int trial_count, uint16_t *order, uint32_t count, const char *progress);

bool bench_counts(void);

/* ---- pairs ---- */

typedef struct bench_method {
    const char *name, *build;
    int    max_vertices;
    void (*prepare)(const bench_set *set);
    bench_run *run;                 /* what: a bench_kind */
    void (*answer)(bench_kind kind, uint32_t pair, bench_answer *answer);
    double (*bytes)(int vertices);  /* of one polygon with all that the method keeps for it */
} bench_method;

extern const bench_method tuff_float_bench_tuff, tuff_q16_bench_tuff, tuff_float_bench_textbook, tuff_q16_bench_textbook;
extern const bench_method bench_box2d, bench_chipmunk;

/* The same pairs for the same kind and vertices, however many of them. */
void bench_make_set(bench_set *set, bench_kind kind, int least, int most, uint32_t count);

/* All vertex counts of one kind; prints the rows. */
void bench_pairs(bench_kind kind);
#define BENCH_PAIR_STEPS 64         /* calls of bench_measure in it */

/* ---- scenes ---- */

typedef struct bench_scene {
    bench_shape octagons[BENCH_OCTAGONS], hull;
    int32_t     radii[BENCH_OCTAGONS];      /* bounding radii */
    bench_piece pieces[BENCH_PIECES];
    bench_frame frames[BENCH_FRAMES];
} bench_scene;

typedef struct bench_scene_method {
    const char *scene, *name, *build;
    void (*prepare)(const bench_scene *scene);
    bench_run *run;                 /* items: frames; hits: pushes and stopped beams */
    uint32_t (*bytes)(void);        /* of terrain, shapes and index */
    int what;                       /* passed to run */
} bench_scene_method;

extern const bench_scene_method tuff_float_bench_scene, tuff_q16_bench_scene, tuff_float_bench_linear_scene, tuff_q16_bench_linear_scene;
extern const bench_scene_method tuff_float_bench_textbook_scene, tuff_q16_bench_textbook_scene;
extern const bench_scene_method bench_box2d_scene, bench_chipmunk_scene;

void bench_scenes(void);
#define BENCH_SCENE_STEPS 1

/* ---- scale ---- */

#define BENCH_CALLS      1024       /* bodies, or beams */
#define BENCH_MAX_PIECES 65000

typedef enum bench_scale_kind { BENCH_ENTITY_HULL, BENCH_ENTITY_CIRCLE, BENCH_BEAM, BENCH_INSERT } bench_scale_kind;

typedef struct bench_crowd {        /* pieces of the scene's octagons, and where the calls are made */
    bench_shape octagons[BENCH_OCTAGONS], hull;
    int32_t     radii[BENCH_OCTAGONS];
    bench_piece pieces[BENCH_MAX_PIECES];
    uint32_t    piece_count;
    bench_body  bodies[BENCH_CALLS];
    bench_point beams[BENCH_CALLS][2];
} bench_crowd;

typedef struct bench_scale_method {
    const char *build;
    void (*prepare)(const bench_crowd *crowd);
    void (*reset)(void);
    bench_run *run;                 /* what: a bench_scale_kind */
    uint32_t (*bytes)(void);        /* of the index */
} bench_scale_method;

extern const bench_scale_method tuff_float_bench_scale, tuff_q16_bench_scale;

void bench_scale(void);
#define BENCH_SCALE_STEPS 43

#ifdef __cplusplus
}
#endif

#endif
