/* See print.h. */
#include "print.h"

#include "machine.h"

void print_whole(uint64_t number)
{
    char text[21];
    char *digit = text + sizeof text - 1;
    *digit = '\0';
    do {
        *--digit = (char)('0' + number % 10);
        number /= 10;
    } while (number > 0);
    machine_print(digit);
}

void print_number(double number)
{
    uint64_t millionths = (uint64_t)(number * 1e6 + 0.5);
    uint64_t place;
    print_whole(millionths / 1000000);
    machine_print(".");
    for (place = 100000; place > 1 && millionths % 1000000 < place; place /= 10)
        machine_print("0");
    print_whole(millionths % 1000000);
}
