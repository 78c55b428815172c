/*
 * The machine is a bare Cortex-M4F. What a program prints and saves goes through
 * semihosting to the debugger, here QEMU.
 */
#include <string.h>

#include "machine.h"

/* From mps2_an386.ld. */
extern uint32_t data_in_flash[], data_start[], data_end[], bss_start[], bss_end[];
extern uint32_t stack_start[], stack_end[];

int main(void);
void reset(void);
void start(void);

#define PAINT 0xc5c5c5c5u       /* what untouched stack is filled with */

/* Operations of semihosting, and how it opens a file to append. */
#define SYS_OPEN 0x01
#define SYS_CLOSE 0x02
#define SYS_WRITE0 0x04
#define SYS_WRITE 0x05
#define SYS_SEEK 0x0a
#define SYS_FLEN 0x0c
#define SYS_EXIT 0x18
#define APPEND_BINARY 9

/* Reasons for SYS_EXIT: the program ended, or it could not go on. */
#define APPLICATION_EXIT ((const void *)0x20026)
#define RUN_TIME_ERROR ((const void *)0x20023)

static intptr_t semihosting(int operation, const void *argument)
{
    register intptr_t result __asm__("r0") = operation;
    register const void *block __asm__("r1") = argument;
    __asm__ volatile("bkpt 0xab" : "+r"(result) : "r"(block) : "memory");
    return result;
}

void machine_print(const char *text)
{
    semihosting(SYS_WRITE0, text);
}

int machine_append(const char *file, const void *bytes, size_t len)
{
    const uintptr_t opening[] = {(uintptr_t)file, APPEND_BINARY, strlen(file)};
    intptr_t handle = semihosting(SYS_OPEN, opening);
    const uintptr_t writing[] = {(uintptr_t)handle, (uintptr_t)bytes, len};
    uintptr_t at[] = {(uintptr_t)handle, 0};
    int written;
    if (handle == -1)
        return 0;
    /* QEMU 7.2 opens a file to append at its beginning. */
    at[1] = (uintptr_t)semihosting(SYS_FLEN, at);
    written = semihosting(SYS_SEEK, at) == 0 && semihosting(SYS_WRITE, writing) == 0;
    return semihosting(SYS_CLOSE, at) == 0 && written;
}

size_t machine_stack_used(void)
{
    const volatile uint32_t *word = stack_start;
    while (word < stack_end && *word == PAINT)
        word++;
    return (size_t)(stack_end - word) * sizeof *word;
}

/* The first instructions: before the FPU is on, nothing may touch its registers, and
 * no compiled function promises that. CPACR: full access to coprocessors 10 and 11. */
__attribute__((naked)) void reset(void)
{
    __asm__("ldr r0, =0xe000ed88\n"
            "ldr r1, [r0]\n"
            "orr r1, r1, #0x00f00000\n"
            "str r1, [r0]\n"
            "dsb\n"
            "isb\n"
            "b start\n");
}

/* Nothing is on the stack that this function would return to. */
void start(void)
{
    volatile uint32_t *word;
    const uint32_t *from = data_in_flash;
    /* Down to what this function itself uses. */
    for (word = stack_start; word < (uint32_t *)__builtin_frame_address(0) - 16; word++)
        *word = PAINT;
    for (word = data_start; word < data_end; word++)
        *word = *from++;
    for (word = bss_start; word < bss_end; word++)
        *word = 0;
    semihosting(SYS_EXIT, main() == 0 ? APPLICATION_EXIT : RUN_TIME_ERROR);
    for (;;) {
    }
}

/* Also of a stack that is too small: it lies where memory begins. */
static void fault(void)
{
    machine_print("the processor met a fault\n");
    semihosting(SYS_EXIT, RUN_TIME_ERROR);
    for (;;) {
    }
}

__attribute__((section(".vectors"), used)) static const struct {
    uint32_t *stack;
    void (*handlers[6])(void);
} vectors = {stack_end, {reset, fault, fault, fault, fault, fault}};
