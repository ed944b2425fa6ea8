/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   What each model of an outline costs, in both builds: models.py writes models and places into a file and reads what this prints.

     bench-models time FILE    a line `outline,model,build,query ns wrong` for each: median ns a call; places answered wrongly
     bench-models count FILE   under callgrind: a dump of the same name for each; see scripts/count-instructions */
#include "model_side.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define BUILDS 2

static const model_side *const sides[BUILDS] = { &model_side_float, &model_side_q16 };

/* The outline being measured. */
static int model_count, place_count;
static model_place places[MODEL_MOST_PLACES];
static bool touched[MODEL_QUERIES][MODEL_MOST_PLACES];   /* what the picture says */
static uint16_t order[MODEL_MOST_PLACES];

/* ---- The file: whole numbers between white space */

static void fail(const char *text)
{
    fprintf(stderr, "bench-models: %s\n", text);
    exit(1);
}

static int32_t number(FILE *file)
{
    int32_t value;
    if (fscanf(file, "%" SCNd32, &value) != 1) fail("the file of models ends early");
    return value;
}

static uint32_t bits(FILE *file)
{
    uint32_t value;
    if (fscanf(file, "%" SCNu32, &value) != 1) fail("the file of models ends early");
    return value;
}

static int count_up_to(FILE *file, int most)
{
    int32_t value = number(file);
    if (value < 0 || value > most) fail("the file of models has a count that is too large");
    return value;
}

static bench_point point(FILE *file)
{
    int32_t x = number(file);
    return (bench_point){ x, number(file) };
}

static void read_queries(FILE *file, model_queries *queries)
{
    queries->radius = number(file);
    queries->hull.count = count_up_to(file, BENCH_MAX_VERTICES);
    for (int i = 0; i < queries->hull.count; i++) queries->hull.vertices[i] = point(file);
}

static void read_places(FILE *file)
{
    place_count = count_up_to(file, MODEL_MOST_PLACES);
    for (int i = 0; i < place_count; i++) {
        places[i].middle = point(file);
        places[i].reach = point(file);
        for (int query = 0; query < MODEL_QUERIES; query++) touched[query][i] = number(file) != 0;
    }
}

static void read_parts(FILE *file, model_source *source)
{
    int vertices = 0;
    source->part_count = count_up_to(file, MODEL_MOST_PARTS);
    for (int i = 0; i < source->part_count; i++) {
        model_part *part = &source->parts[i];
        part->count = count_up_to(file, MODEL_MOST_VERTICES - vertices);
        part->internal = bits(file);
        for (int k = 0; k < part->count; k++) source->vertices[vertices++] = point(file);
    }
}

static void read_models(FILE *file)
{
    static model_source source;
    model_count = count_up_to(file, MODEL_MOST);
    for (int model = 0; model < model_count; model++) {
        source.position = point(file);
        source.radius = number(file);
        source.bounding_radius = number(file);
        read_parts(file, &source);
        for (int build = 0; build < BUILDS; build++) sides[build]->bake(model, &source);
    }
}

/* ---- Measuring */

static int wrong_answers(const model_side *side, int what)
{
    int wrong = 0;
    for (int i = 0; i < place_count; i++) {
        uint16_t place = (uint16_t)i;
        wrong += (side->run(what, &place, 1) != 0) != touched[what % MODEL_QUERIES][i];
    }
    return wrong;
}

static void measure(int outline, int what)
{
    bench_trial trials[BUILDS] = { { "", sides[0]->run, what, NULL, 0.0 }, { "", sides[1]->run, what, NULL, 0.0 } };
    for (int i = 0; i < BUILDS; i++) {
        snprintf(trials[i].key, sizeof trials[i].key, "%d,%d,%s,%d", outline, what / MODEL_QUERIES, sides[i]->name, what % MODEL_QUERIES);
    }
    for (int i = 0; i < place_count; i++) order[i] = (uint16_t)i;
    bench_measure(trials, BUILDS, order, (uint32_t)place_count, "models");
    for (int i = 0; i < BUILDS && !bench_counts(); i++) {
        printf("%s %.3f %d\n", trials[i].key, trials[i].ns, wrong_answers(sides[i], what));
    }
}

static void measure_outline(FILE *file, int outline, int outline_count, const model_queries *queries)
{
    read_places(file);
    read_models(file);
    for (int build = 0; build < BUILDS; build++) sides[build]->prepare(queries, places, place_count);
    if (outline == 0) bench_begin(bench_counts(), (unsigned)(outline_count * model_count * MODEL_QUERIES));
    for (int what = 0; what < model_count * MODEL_QUERIES; what++) measure(outline, what);
}

int main(int argc, char **argv)
{
    model_queries queries;
    bool count = argc == 3 && !strcmp(argv[1], "count");
    if (argc != 3 || (!count && strcmp(argv[1], "time"))) fail("usage: bench-models time|count FILE");
    FILE *file = fopen(argv[2], "r");
    if (file == NULL) fail("cannot read the file of models");
    bench_begin(count, 1);
    read_queries(file, &queries);
    int outlines = count_up_to(file, INT16_MAX);
    for (int i = 0; i < outlines; i++) measure_outline(file, i, outlines, &queries);
    fclose(file);
    return 0;
}
