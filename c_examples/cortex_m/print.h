/*
 * Numbers as text, on any machine. printf of a C library for microcontrollers takes
 * memory from a heap.
 */
#ifndef PRINT_H
#define PRINT_H

#include <stdint.h>

void print_whole(uint64_t number);

/* A number from 0 to a million, with six decimals. */
void print_number(double number);

#endif
