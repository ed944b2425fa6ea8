/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   QEMU plugin: counts the instructions of the guest between its functions mark_begin and mark_end and prints `instructions NUMBER` on
   standard output for each time, in order. The calls of the two themselves do not count. Written against the plugin interface's version 1,
   of which no header is packaged. */
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#define INTERFACE 1

typedef uint64_t plugin_id;
typedef struct qemu_plugin_tb block;
typedef struct qemu_plugin_insn instruction;
typedef void on_translation(plugin_id id, block *code);
typedef void on_execution(unsigned processor, void *data);

enum { NO_REGISTERS = 0 };
enum { ADD_TO_COUNTER = 0 };

extern void qemu_plugin_register_vcpu_tb_trans_cb(plugin_id id, on_translation *call);
extern void qemu_plugin_register_vcpu_tb_exec_cb(block *code, on_execution *call, int registers, void *data);
extern void qemu_plugin_register_vcpu_tb_exec_inline(block *code, int operation, void *counter, uint64_t value);
extern size_t qemu_plugin_tb_n_insns(const block *code);
extern instruction *qemu_plugin_tb_get_insn(const block *code, size_t index);
extern const char *qemu_plugin_insn_symbol(const instruction *code);

__attribute__((visibility("default"))) int qemu_plugin_version = INTERFACE;
__attribute__((visibility("default"))) int qemu_plugin_install(plugin_id id, const void *machine, int count, char **arguments);

static uint64_t executed, began;

static void begin(unsigned processor, void *data)
{
    (void)processor;
    (void)data;
    began = executed;
}

static void end(unsigned processor, void *data)
{
    (void)processor;
    (void)data;
    printf("instructions %llu\n", (unsigned long long)(executed - began));
    fflush(stdout);
}

/* A block counts all its instructions when it is entered. So the count ends before that of the block of mark_end, and begins after that of
   mark_begin's, which ends with the return. */
static void translate(plugin_id id, block *code)
{
    const char *symbol = qemu_plugin_insn_symbol(qemu_plugin_tb_get_insn(code, 0));
    bool begins = symbol && strcmp(symbol, "mark_begin") == 0, ends = symbol && strcmp(symbol, "mark_end") == 0;
    (void)id;
    if (ends) qemu_plugin_register_vcpu_tb_exec_cb(code, end, NO_REGISTERS, NULL);
    qemu_plugin_register_vcpu_tb_exec_inline(code, ADD_TO_COUNTER, &executed, qemu_plugin_tb_n_insns(code));
    if (begins) qemu_plugin_register_vcpu_tb_exec_cb(code, begin, NO_REGISTERS, NULL);
}

int qemu_plugin_install(plugin_id id, const void *machine, int count, char **arguments)
{
    (void)machine;
    (void)count;
    (void)arguments;
    qemu_plugin_register_vcpu_tb_trans_cb(id, translate);
    return 0;
}
