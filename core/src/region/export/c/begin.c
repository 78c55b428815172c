#ifndef @_INCLUDED
#define @_INCLUDED

#include <float.h>
#include <math.h>

/* Define @_FLOAT before this file for float in place of double. With -ffp-contract=off the
 * answers are the library's, bit by bit but for what sin, cos and atan2 of <math.h> round
 * otherwise; define @_sin, @_cos and @_atan2 for others. */
#ifdef @_FLOAT
typedef float @_real;
#define @_EPSILON FLT_EPSILON
#define @_SQRT_EPSILON 3.4526698e-4f
#define @_abs fabsf
#define @_sqrt sqrtf
#ifndef @_atan2
#define @_atan2 atan2f
#endif
#else
typedef double @_real;
#define @_EPSILON DBL_EPSILON
#define @_SQRT_EPSILON (1.0 / 67108864.0)
#define @_abs fabs
#define @_sqrt sqrt
#ifndef @_sin
#define @_sin sin
#define @_cos cos
#endif
#ifndef @_atan2
#define @_atan2 atan2
#endif
#endif

#ifdef __GNUC__
#define @_LET __attribute__((unused)) const @_real
#else
#define @_LET const @_real
#endif
