
#ifndef @_sin
/* Of an angle by quarter turns, as the library's in float; beyond 400 radians it is NAN, and
 * nothing is inside. */
static inline float @_sine_of(float turned, int quarters)
{
    const float angle = turned >= -400 && turned <= 400 ? turned : 0;
    const int count = (int)(angle * 0.636619772f + (angle < 0 ? -0.5f : 0.5f));
    const float rest = angle - (float)count * 1.5708008f - (float)count * -4.4543995e-6f
                       - (float)count * -5.5644316e-11f;
    const float square = rest * rest;
    const int place = (count + quarters) & 3;
    const float sine =
        rest + rest * (square * ((-1.9515296e-4f * square + 8.332161e-3f) * square - 1.6666655e-1f));
    const float cosine =
        1.0f - 0.5f * square
        + square * square * ((2.4433157e-5f * square - 1.3887316e-3f) * square + 4.1666646e-2f);
    const float value = place & 1 ? cosine : sine;
    if (angle != turned)
        return (float)NAN;
    return place & 2 ? -value : value;
}

static inline float @_sin(float angle)
{
    return @_sine_of(angle, 0);
}

static inline float @_cos(float angle)
{
    return @_sine_of(angle, 1);
}
#endif
