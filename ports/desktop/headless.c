/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Flies both builds for a while and prints what happened and, last, the two replay hashes. */
#include "headless.h"

#include <stdio.h>

#include "game.h"

static const char *const event_names[SCENE_EVENTS] = {
    "shots fired", "shots that ricocheted", "steps with the beam on terrain", "rocks blown up", "rocks grown again",
    "enemies shot down", "ship's pushes off rocks", "ship's pushes off the floor", "ship's bumps with floaters",
    "ship's bumps with enemies", "ships lost"
};

typedef struct sums {
    uint64_t candidates, tests, contacts;
    unsigned most_contacts;
} sums;

static void add_counts(const game *g, sums *all)
{
    for (int i = 0; i < SIDES; i++) {
        scene_counts counts;
        g->sides[i]->count(&counts);
        all[i].candidates += counts.candidates;
        all[i].tests += counts.tests;
        all[i].contacts += counts.contacts;
        if (counts.contacts > all[i].most_contacts) all[i].most_contacts = counts.contacts;
    }
}

static void print_events(const game *g)
{
    uint16_t events[SIDES][SCENE_EVENTS];
    for (int i = 0; i < SIDES; i++) g->sides[i]->events(events[i]);
    for (int e = 0; e < SCENE_EVENTS; e++) printf("%-42s %10u %10u\n", event_names[e], events[SIDE_FLOAT][e], events[SIDE_Q16][e]);
}

static void print_summary(const game *g, const options *o, const sums *all)
{
    double frames = (double)g->frame;
    const sums *f = &all[SIDE_FLOAT], *q = &all[SIDE_Q16];
    printf("tuff-demo: seed %lu, %lu frames, %s\n", (unsigned long)o->seed, (unsigned long)g->frame,
           o->split ? "both builds fly by one autopilot" : "each build flies by its own autopilot");
    printf("%-42s %10s %10s\n", "", side_names[SIDE_FLOAT], side_names[SIDE_Q16]);
    print_events(g);
    printf("%-42s %10.1f %10.1f\n", "candidates a frame", (double)f->candidates / frames, (double)q->candidates / frames);
    printf("%-42s %10.1f %10.1f\n", "convex parts of the candidates a frame", (double)f->tests / frames, (double)q->tests / frames);
    printf("%-42s %10.2f %10.2f\n", "contacts a frame", (double)f->contacts / frames, (double)q->contacts / frames);
    printf("%-42s %10u %10u\n", "most contacts in a frame", f->most_contacts, q->most_contacts);
    printf("%-42s %10.2f %10.2f\n", "microseconds a frame, the whole scene", g->total[SIDE_FLOAT] / frames, g->total[SIDE_Q16] / frames);
    printf("%-42s %10lu %10lu\n", "bytes of the scene's state",
           (unsigned long)g->sides[SIDE_FLOAT]->bytes, (unsigned long)g->sides[SIDE_Q16]->bytes);
    printf("the two ships are %.5f units apart\n", game_drift(g));
    printf("replay float %08lX\n", (unsigned long)g->hashes[SIDE_FLOAT]);
    printf("replay q16 %08lX\n", (unsigned long)g->hashes[SIDE_Q16]);
}

int headless_run(const options *o)
{
    game g;
    sums all[SIDES] = {{0, 0, 0, 0}, {0, 0, 0, 0}};
    uint32_t frames = o->frames != 0 ? o->frames : 3600;
    game_start(&g, o);
    g.autopilot = true;
    while (g.frame < frames) {
        if (o->split) game_step_together(&g, 0);
        else game_step(&g, g.sides[SIDE_FLOAT]->pilot(), g.sides[SIDE_Q16]->pilot());
        add_counts(&g, all);
        if (g.frame % 60 == 0) game_check(&g);
    }
    game_check(&g);
    print_summary(&g, o, all);
    if (fflush(stdout) == 0 && !ferror(stdout)) return 0;
    fprintf(stderr, "tuff-demo: cannot write the summary\n");
    return 1;
}
