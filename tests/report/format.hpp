// Numbers and text as a reader wants them: few digits, SI prefixes, true superscripts.
#ifndef REPORT_FORMAT_HPP
#define REPORT_FORMAT_HPP

#include <cstdint>
#include <string>

namespace report {

// Text made safe for HTML and SVG.
std::string escape(const std::string& text);

// 0.0123, 4.56, 1 230 000, 1.2 x 10^-7 with real superscripts; "none" for NaN.
std::string number(double value, int significant = 3);

// 1 230 000: whole, grouped by narrow spaces.
std::string count(double value);

// 12.3 µs: the SI prefix that leaves one to three digits before the point.
std::string si(double value, const std::string& unit, int significant = 3);

// 0.013 -> 1.3%.
std::string percent(double fraction, int significant = 2);

// " (+1.3%)", which stands behind a time; nothing of NaN.
std::string spread_words(double spread);

// 10 with a superscript exponent; 1 and 10 are written out.
std::string power_of_ten(int exponent);
std::string nearest_power_of_ten(double value);

// For CSV and for `key: value` lines: shortest text that reads back as the same number.
std::string plain(double value);
std::string hex(std::uint64_t value);

// "a, b and c"
template <class Strings>
std::string list_words(const Strings& words) {
    std::string text;
    std::size_t i = 0, n = words.size();
    for (const std::string& word : words) {
        if (i > 0) text += i + 1 == n ? " and " : ", ";
        text += word;
        ++i;
    }
    return text;
}

}  // namespace report

#endif
