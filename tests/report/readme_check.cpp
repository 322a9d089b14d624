// Every figure of README.md and of tests/report/README.md is one that the report printed. In the section Figures, a
// number in a table's cell behind the first one, or in bold in the prose, is a figure. A comment below names their keys,
// in their order:
//
//     | lake beside a dry bank: volume gained | 7e-16 | 7.4% |
//
//     <!-- figures
//     =water.lake.contdyn_gained
//     =water.lake.textbook_gained
//     -->
//
// =key  the same on every machine and in the sample: compared, to the digits that stand there
// ~key  the same on every machine, of `--full` alone: compared if that is the run looked at
// key   a time, or a ratio of times: it must have been printed
// @key  likewise, of `--full` alone
#include <cmath>
#include <regex>
#include <sstream>

#include "check.hpp"

std::string source;

namespace {

std::map<std::string, double> summary() {
    std::map<std::string, double> figures;
    std::istringstream text(read(first + "/summary.txt"));
    for (std::string line; std::getline(text, line);) {
        const std::size_t colon = line.find(": ");
        if (colon != std::string::npos) figures[line.substr(0, colon)] = std::strtod(line.c_str() + colon + 2, nullptr);
    }
    return figures;
}

// 1, 6.7, 16 000, 2e-15: as written, with half a unit of the last digit.
struct Number {
    std::string text;
    double value, half;
};

std::vector<Number> numbers_in(const std::string& text) {
    static const std::regex kNumber(R"(\d+(?: \d{3})*(?:\.(\d+))?(?:e(-?\d+))?)");
    std::vector<Number> found;
    for (std::sregex_iterator it(text.begin(), text.end(), kNumber), end; it != end; ++it) {
        std::string digits = it->str();
        for (std::size_t space; (space = digits.find(' ')) != std::string::npos;) digits.erase(space, 1);
        const double exponent = (*it)[2].matched ? std::stod((*it)[2].str()) : 0;
        double last = std::pow(10, exponent - double((*it)[1].length()));
        if (!(*it)[1].matched && !(*it)[2].matched) // zeros that end a whole number may stand for digits
            for (std::size_t i = digits.size(); i-- > 1 && digits[i] == '0';) last *= 10;
        found.push_back({it->str(), std::stod(digits), 0.501 * last});
    }
    return found;
}

// What stands in the cells behind the first, or in bold.
std::string figures_of(const std::string& line) {
    std::string text;
    if (line[0] == '|') {
        const std::size_t second = line.find('|', 1);
        return second == std::string::npos ? "" : line.substr(second);
    }
    for (std::size_t from = line.find("**"); from != std::string::npos; from = line.find("**", from)) {
        const std::size_t to = line.find("**", from + 2);
        if (to == std::string::npos) break;
        text += " | " + line.substr(from + 2, to - from - 2);
        from = to + 2;
    }
    return text;
}

// The figures and the keys of a file's section, each in their order.
void read_section(const std::string& file, std::vector<Number>& figures, std::vector<std::string>& keys) {
    std::istringstream text(read(source + "/" + file));
    bool inside = false, comment = false, body = false;
    for (std::string line; std::getline(text, line);) {
        if (line.rfind("## ", 0) == 0) inside = line == "## Figures";
        if (!inside) continue;
        if (comment) {
            comment = line != "-->";
            if (comment) keys.push_back(line);
            else
                expect(figures.size() == keys.size(), std::to_string(figures.size()) + " figures and " +
                                                          std::to_string(keys.size()) + " keys up to " + keys.back());
            continue;
        }
        comment = line == "<!-- figures";
        const bool row = !line.empty() && line[0] == '|', rule = line.rfind("|---", 0) == 0;
        if (rule || !row) body = rule; // what stands above the rule names the columns
        if (rule || comment || (row && !body)) continue;
        for (const Number& number : numbers_in(figures_of(line))) figures.push_back(number);
    }
}

void every_readme_figure_is_printed() {
    const std::map<std::string, double> printed = summary();
    const bool full = printed.count("report.full") > 0;
    std::vector<Number> figures;
    std::vector<std::string> keys;
    for (const char* file : {"README.md", "tests/report/README.md"}) read_section(file, figures, keys);
    expect(figures.size() == keys.size(), "figures without a key");
    std::size_t compared = 0;
    for (std::size_t i = 0; i < std::min(figures.size(), keys.size()); ++i) {
        const char mark = keys[i][0];
        const bool exact = mark == '=' || mark == '~', full_alone = mark == '~' || mark == '@';
        const std::string key = exact || full_alone ? keys[i].substr(1) : keys[i];
        if (full_alone && !full) continue;
        auto it = printed.find(key);
        expect(it != printed.end(), "not printed: " + key + ", said to be " + figures[i].text);
        if (it == printed.end() || !exact) continue;
        ++compared;
        expect(std::fabs(std::fabs(it->second) - figures[i].value) <= figures[i].half,
               key + ": printed " + std::to_string(it->second) + ", said to be " + figures[i].text);
    }
    expect(figures.size() >= 30 && compared >= 8, "hardly any figures");
}

} // namespace

Checks readme_checks() { return {{"every_readme_figure_is_printed", every_readme_figure_is_printed}}; }
