/*
 * What the programs need of the machine they run on. host.c has it on an operating
 * system, board.c on a bare Cortex-M4.
 */
#ifndef MACHINE_H
#define MACHINE_H

#include <stddef.h>
#include <stdint.h>

/* Prints a text. */
void machine_print(const char *text);

/* Appends bytes to a file on the host. Returns 0 if it cannot. */
int machine_append(const char *file, const void *bytes, size_t len);

/* The most stack in bytes that was ever in use; 0 if the machine cannot tell. */
size_t machine_stack_used(void);

#endif
