// Cosine and sine of an angle, with the same bits on every machine.
#pragma once

namespace cd {

template <class T> struct CosineAndSine { T cosine, sine; };

// Of an angle from -pi to pi, a number or numbers side by side, to some 1e-15: Taylor's series for an eighth of it, and
// three times the double of the angle. one: as many times 1.
template <class T> CosineAndSine<T> turn_by(T angle, T one) {
    const T a = 0.125 * angle, square = a * a;
    // sin a = a s_2, cos a = c_2: s_n = 1 - a^2 / (n (n + 1)) s_{n+2}, c_n = 1 - a^2 / (n (n - 1)) c_{n+2}.
    T s = one, c = one;
    for (double n = 16; n > 1; n -= 2) {
        s = one - (1 / (n * (n + 1))) * (square * s);
        c = one - (1 / (n * (n - 1))) * (square * c);
    }
    s = a * s;
    for (int doubled = 0; doubled < 3; ++doubled) {
        const T both = 2.0 * (s * c);
        c = one - 2.0 * (s * s);
        s = both;
    }
    return {c, s};
}

} // namespace cd
