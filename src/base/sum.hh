// A sum whose error does not grow with the number of terms (Neumaier 1974), added in a fixed order.
#pragma once

namespace cd {

struct Sum {
    double total = 0, lost = 0;

    void add(double term) {
        const double next = total + term;
        const bool larger = (total < 0 ? -total : total) >= (term < 0 ? -term : term);
        lost += larger ? (total - next) + term : (term - next) + total;
        total = next;
    }
    // Where the total is not finite, what was lost means nothing.
    double value() const { return lost - lost == 0 ? total + lost : total; }
};

} // namespace cd
