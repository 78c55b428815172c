/* All that a program of core needs around it: a start, and the memory functions
 * that any C library has. */
#include <stddef.h>
#include <stdint.h>

int critreg_run(const uint8_t *text, size_t length, uint64_t seed);

static const char domain[] = "parameter mu in [0, 1]";

void _start(void) {
    volatile int result = critreg_run((const uint8_t *)domain, sizeof domain - 1, 3);
    (void)result;
    for (;;) {
    }
}

void *memcpy(void *to, const void *from, size_t n) {
    char *t = to;
    const char *f = from;
    while (n--) *t++ = *f++;
    return to;
}

void *memmove(void *to, const void *from, size_t n) {
    char *t = to;
    const char *f = from;
    if (t < f)
        while (n--) *t++ = *f++;
    else
        while (n--) t[n] = f[n];
    return to;
}

void *memset(void *to, int value, size_t n) {
    char *t = to;
    while (n--) *t++ = (char)value;
    return to;
}

int memcmp(const void *a, const void *b, size_t n) {
    const unsigned char *x = a, *y = b;
    for (; n--; x++, y++)
        if (*x != *y) return *x - *y;
    return 0;
}

int bcmp(const void *a, const void *b, size_t n) {
    return memcmp(a, b, n);
}
