/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The trace of a replay, by which scripts/run-target finds the first step and body that differ from the golden one: the names of the
   groups of bodies, then a line a step with a character a body: 6 bits of the hash of all its steps so far, so that what once differed
   stays different. Empty unless compiled with REPLAY_TRACE. */
#ifndef TRACE_H
#define TRACE_H

#include <stdio.h>

#include <tuff/tuff.h>

/* FNV-1a over words, with the high half folded down. */
static uint32_t fold(uint32_t hash, uint32_t word)
{
    hash = (hash ^ word) * 16777619u;
    return hash ^ hash >> 15;
}

static uint32_t fold_body(uint32_t hash, const tuff_body *body)
{
    hash = fold(hash, (uint32_t)tuff_to_q16_16(body->position.x));
    hash = fold(hash, (uint32_t)tuff_to_q16_16(body->position.y));
    hash = fold(hash, (uint32_t)tuff_to_q16_16(body->velocity.x));
    return fold(hash, (uint32_t)tuff_to_q16_16(body->velocity.y));
}

#ifdef REPLAY_TRACE
static void trace_text(const char *text)
{
    while (*text != '\0') putchar(*text++);
}

static void trace_hash(uint32_t hash)
{
    putchar("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+-"[hash >> 26]);
}

static void trace_body(uint32_t *history, const tuff_body *body)
{
    *history = fold_body(*history, body);
    trace_hash(*history);
}
#else
static void trace_text(const char *text)                          { (void)text; }
static void trace_hash(uint32_t hash)                             { (void)hash; }
static void trace_body(uint32_t *history, const tuff_body *body)  { (void)history; (void)body; }
#endif

#endif
