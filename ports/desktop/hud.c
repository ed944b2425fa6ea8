/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Words for the numbers: long ones where there is room. */
#include "hud.h"

#include <stdio.h>
#include <string.h>

static void bar(char *text, unsigned value, unsigned most, unsigned width)
{
    unsigned full = (value * width + most - 1) / most;
    for (unsigned i = 0; i < width; i++) text[i] = i < full ? '#' : '-';
    text[width] = '\0';
}

static void cut(char *line, unsigned columns)
{
    if (columns < HUD_LENGTH) line[columns] = '\0';
}

void hud_title(const game *g, unsigned columns, char line[HUD_LENGTH])
{
    char shield[SCENE_SHIELD + 1], energy[7], drift[40];
    scene_counts counts;
    g->sides[g->shown]->count(&counts);
    bar(shield, counts.shield, SCENE_SHIELD, SCENE_SHIELD);
    bar(energy, counts.energy, SCENE_ENERGY, 6);
    snprintf(drift, sizeof drift, game_drift(g) < 10 ? "drift %.5f" : "drift %.1f", game_drift(g));
    const char *state = g->paused ? "paused" : g->autopilot ? "autopilot" : "";
    if (g->split) {
        snprintf(line, HUD_LENGTH, "tuff float | Q16.16  ships %.5f units apart  %s", game_drift(g), columns >= 60 ? state : "");
    } else if (columns >= 76) {
        snprintf(line, HUD_LENGTH, "tuff %-6s  shield %s  beam %s  score %lu  %s  %s", side_names[g->shown], shield, energy,
                 (unsigned long)counts.score, drift, state);
    } else {
        snprintf(line, HUD_LENGTH, "tuff %s  score %lu  %s", side_names[g->shown], (unsigned long)counts.score, drift);
    }
    cut(line, columns);
}

void hud_counts(const game *g, int which, unsigned columns, char line[HUD_LENGTH])
{
    scene_counts counts;
    g->sides[which]->count(&counts);
    if (columns >= 62) {
        snprintf(line, HUD_LENGTH, "candidates %-3u tests %-3u contacts %-2u  %5.1f us/step  pieces %-3u",
                 counts.candidates, counts.tests, counts.contacts, g->microseconds[which], counts.pieces);
    } else if (columns >= 47) {
        snprintf(line, HUD_LENGTH, "candidates %-3u tests %-3u contacts %-2u %5.1f us", counts.candidates, counts.tests, counts.contacts,
                 g->microseconds[which]);
    } else if (columns >= 36) {
        snprintf(line, HUD_LENGTH, "%s cand %u tests %u cont %u %.0f us", side_names[which], counts.candidates, counts.tests,
                 counts.contacts, g->microseconds[which]);
    } else {
        snprintf(line, HUD_LENGTH, "%s cand %u tests %u", side_names[which], counts.candidates, counts.tests);
    }
    cut(line, columns);
}
