
/* Sine and cosine of an angle. */
#ifdef @_sin
static inline void @_sin_cos(@_real angle, @_real *sine, @_real *cosine)
{
    *sine = @_sin(angle);
    *cosine = @_cos(angle);
}
#else
/* The library's own in float, by quarter turns. Beyond 400 radians they are NAN, and nothing
 * is inside. */
static inline void @_sin_cos(float angle, float *sine, float *cosine)
{
    const int known = angle >= -400 && angle <= 400;
    const float turned = known ? angle : 0;
    const int count = (int)(turned * 0.636619772f + (turned < 0 ? -0.5f : 0.5f));
    const float rest = turned - (float)count * 1.5708008f - (float)count * -4.4543995e-6f
                       - (float)count * -5.5644316e-11f;
    const float square = rest * rest;
    const float s =
        rest + rest * (square * ((-1.9515296e-4f * square + 8.332161e-3f) * square - 1.6666655e-1f));
    const float c =
        1.0f - 0.5f * square
        + square * square * ((2.4433157e-5f * square - 1.3887316e-3f) * square + 4.1666646e-2f);
    const float a = count & 1 ? c : s, b = count & 1 ? s : c;
    *sine = !known ? (float)NAN : count & 2 ? -a : a;
    *cosine = !known ? (float)NAN : (count + 1) & 2 ? -b : b;
}
#endif
