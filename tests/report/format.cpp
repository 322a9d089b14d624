#include "format.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace report {

std::string escape(const std::string& text) {
    std::string safe;
    for (char c : text) {
        switch (c) {
        case '&': safe += "&amp;"; break;
        case '<': safe += "&lt;"; break;
        case '>': safe += "&gt;"; break;
        case '"': safe += "&quot;"; break;
        default: safe += c;
        }
    }
    return safe;
}

static std::string superscript(int value) {
    static const char* const kDigits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text = value < 0 ? "⁻" : "";
    for (char c : std::to_string(std::abs(value))) text += kDigits[c - '0'];
    return text;
}

static std::string rounded(double value, int decimals) {
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", decimals, value);
    return text;
}

std::string power_of_ten(int exponent) {
    if (exponent == 0) return "1";
    if (exponent == 1) return "10";
    return "10" + superscript(exponent);
}

std::string nearest_power_of_ten(double value) { return power_of_ten(int(std::lround(std::log10(value)))); }

std::string count(double value) {
    std::string digits = rounded(std::fabs(value), 0), text;
    for (std::size_t i = 0; i < digits.size(); ++i) {
        if (i > 0 && (digits.size() - i) % 3 == 0 && digits.size() > 4) text += "\u202f";
        text += digits[i];
    }
    return (value < 0 ? "−" : "") + text;
}

std::string number(double value, int significant) {
    if (std::isnan(value)) return "none";
    if (std::isinf(value)) return value < 0 ? "−∞" : "∞";
    if (value == 0) return "0";
    // The exponent after rounding to the digits shown: 9.996 is 10.0.
    char text[64];
    std::snprintf(text, sizeof text, "%.*e", significant - 1, value);
    int exponent = std::atoi(std::string(text).substr(std::string(text).find('e') + 1).c_str());
    if (exponent < -3 || exponent > 8) {
        std::string mantissa = rounded(std::fabs(std::strtod(text, nullptr)) / std::pow(10.0, exponent),
                                       significant - 1);
        std::string sign = value < 0 ? "−" : "";
        return sign + mantissa + "·" + power_of_ten(exponent);
    }
    int decimals = significant - 1 - exponent;
    if (decimals <= 0) return count(std::strtod(text, nullptr));
    return (value < 0 ? "−" : "") + rounded(std::fabs(value), decimals);
}

std::string si(double value, const std::string& unit, int significant) {
    static const char* const kPrefixes[] = {"f", "p", "n", "µ", "m", "", "k", "M", "G", "T"};
    if (value == 0 || !std::isfinite(value)) return number(value) + " " + unit;
    int step = 5;
    double size = std::fabs(value);
    while (size < 0.9995 && step > 0) size *= 1e3, --step;
    while (size >= 999.5 && step < 9) size /= 1e3, ++step;
    return number(value < 0 ? -size : size, significant) + "\u00a0" + kPrefixes[step] + unit;
}

std::string percent(double fraction, int significant) { return number(fraction * 100, significant) + "%"; }

std::string spread_words(double spread) {
    return std::isnan(spread) ? "" : " (+" + percent(spread, spread < 0.095 ? 1 : 2) + ")";
}

std::string plain(double value) {
    char text[64];
    for (int digits = 6; digits <= 17; ++digits) {
        std::snprintf(text, sizeof text, "%.*g", digits, value);
        if (std::isnan(value) || std::strtod(text, nullptr) == value) break;
    }
    return text;
}

std::string hex(std::uint64_t value) {
    char text[32];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(value));
    return text;
}

}  // namespace report
