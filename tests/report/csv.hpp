// Tables of numbers as comma-separated text.
#ifndef REPORT_CSV_HPP
#define REPORT_CSV_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "format.hpp"

namespace report {

class Csv {
public:
    explicit Csv(const std::string& header) : text_(header + "\n") {}

    // One row: text, whole numbers and real numbers as they come.
    template <class... Values>
    static std::string line(const Values&... values) {
        std::string line;
        ((line += "," + cell(values)), ...);
        return line.substr(1) + "\n";
    }
    template <class... Values>
    void row(const Values&... values) {
        text_ += line(values...);
    }

    const std::string& text() const { return text_; }

private:
    static std::string cell(const std::string& text) {
        return text.find(',') == std::string::npos ? text : "\"" + text + "\"";
    }
    static std::string cell(const char* text) { return cell(std::string(text)); }
    static std::string cell(double value) { return plain(value); }
    static std::string cell(std::size_t value) { return std::to_string(value); }
    static std::string cell(int value) { return std::to_string(value); }

    std::string text_;
};

}  // namespace report

#endif
