// report_check CHECK FIRST SECOND: looks at what two runs of the report's short form wrote into FIRST and SECOND.
// Never at a time.
#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

std::string first, second;
int failures = 0;

void expect(bool good, const std::string& what) {
    if (good) return;
    std::fprintf(stderr, "wrong: %s\n", what.c_str());
    ++failures;
}

std::string read(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    expect(file.good() && !text.str().empty(), "cannot read " + path + ", or it is empty");
    return text.str();
}

using Row = std::map<std::string, std::string>;

double real(const Row& row, const std::string& column) {
    auto cell = row.find(column);
    expect(cell != row.end() && !cell->second.empty(), "no column " + column);
    return cell == row.end() ? NAN : std::strtod(cell->second.c_str(), nullptr);
}

std::vector<Row> rows_of(const std::string& name) {
    std::istringstream text(read(first + "/" + name));
    auto cells = [](const std::string& line) {
        std::vector<std::string> found;
        std::istringstream stream(line);
        for (std::string cell; std::getline(stream, cell, ',');) found.push_back(cell);
        return found;
    };
    std::string line;
    std::getline(text, line);
    std::vector<std::string> head = cells(line);
    std::vector<Row> rows;
    while (std::getline(text, line)) {
        std::vector<std::string> values = cells(line);
        expect(values.size() == head.size(), name + ": a row of another length: " + line);
        Row row;
        for (std::size_t i = 0; i < head.size() && i < values.size(); ++i) row[head[i]] = values[i];
        rows.push_back(row);
    }
    expect(!rows.empty(), name + " has no rows");
    return rows;
}

// ---- the checks -----------------------------------------------------------------------------------------------------

void outcomes_repeat() {
    for (const char* name : {"outcomes.csv", "chain_figure2.csv", "chain_crossing.csv", "chain_extremes.csv",
                             "chain_hanging_frames.csv", "scene_rope.csv"})
        expect(read(first + "/" + name) == read(second + "/" + name), std::string(name) + " differs between two runs");
    expect(rows_of("outcomes.csv").size() > 100, "fewer than 100 outcomes are hashed");
}

// Exponent of error ~ dt^p by least squares over the five finest steps.
void errors_fall_at_their_order() {
    const std::map<std::string, double> orders = {{"forward_euler", 1}, {"symplectic_euler", 1}, {"implicit_half", 2},
                                                  {"implicit_one", 1}, {"stiff_second", 2}, {"textbook_half", 2}};
    std::map<std::string, std::map<double, double>> errors;  // by method and dt
    for (const Row& row : rows_of("chain_work_precision.csv"))
        if (row.at("case") == "chain.wave.n100" && row.at("precision") == "float64" && real(row, "error") > 1e-9)
            errors[row.at("method")][real(row, "dt_s")] = real(row, "error");
    for (const auto& [method, order] : orders) {
        double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
        for (const auto& [dt, error] : errors[method]) {
            if (n == 5) break;
            double x = std::log(dt), y = std::log(error);
            n += 1, sx += x, sy += y, sxx += x * x, sxy += x * y;
        }
        double slope = (n * sxy - sx * sy) / (n * sxx - sx * sx);
        expect(n == 5 && std::fabs(slope - order) < 0.1, method + " is of order " + std::to_string(slope));
    }
}

void stiff_chains_agree_and_the_textbook_does_not() {
    for (const Row& row : rows_of("chain_extremes.csv")) {
        double stiffness = real(row, "stiffness_over_mass");
        double position = real(row, "position_error"), velocity = real(row, "velocity_error");
        bool one_step = row.at("steps") == "1";
        std::string what = row.at("method") + " at " + row.at("stiffness_over_mass") + " after " + row.at("steps");
        if (row.at("textbook") == "0") {
            expect(position < (one_step ? 1e-5 : 1e-4), what + ": position");
            // lambda = 1/2 keeps as motion what rounding puts into stiff springs
            if (one_step || row.at("method") != "implicit_half")
                expect(velocity < (one_step ? 3e-5 : 1e-3), what + ": velocity");
        } else if (stiffness >= 1e16) {
            expect(!(position < 0.1), what + " works, so that this comparison shows nothing");
        }
    }
}

void explicit_steps_need_many_on_a_stiff_chain() {
    double explicit_steps = 0, implicit_steps = 0;
    for (const Row& row : rows_of("chain_stiff_cheapest.csv"))
        if (real(row, "tolerance") == 0.01)
            explicit_steps = real(row, "explicit_steps"), implicit_steps = real(row, "implicit_steps");
    expect(implicit_steps > 0 && implicit_steps < 200, "no implicit run of under 200 steps reaches 1%");
    expect(explicit_steps > 1000 * implicit_steps, "explicit steps are not a thousand times as many");
}

void the_hanging_rope_stretches_as_it_should() {
    for (const Row& row : rows_of("chain_hanging.csv")) {
        double of_exact = real(row, "mean_stretch") / real(row, "exact_stretch");
        const std::string& method = row.at("method");
        if (method == "implicit_one" || method == "one_step_of_1e4_s")
            expect(std::fabs(of_exact - 1) < 2e-3, method + " hangs at the wrong length, n = " + row.at("springs"));
        if (method == "position_based" && row.at("springs") == "1000")
            expect(of_exact > 5, "the position-based rope is not too soft, so that this comparison shows nothing");
    }
}

void figure_2_is_exact() {
    double sum = 0;
    for (const Row& row : rows_of("chain_figure2.csv")) {
        double exact = real(row, "exact");
        sum += exact;
        expect(std::fabs(real(row, "both_passes") - exact) <= 1e-10 * exact, "node " + row.at("node_from_impulse"));
        if (real(row, "node_from_impulse") < 0)
            expect(real(row, "forward_pass") == 0, "the forward pass runs backward");
    }
    expect(std::fabs(sum - 1) < 1e-4, "the exact filter does not sum to 1");
}

void a_disturbance_crosses_as_claimed() {
    std::set<std::string> seen;
    for (const Row& row : rows_of("chain_crossing.csv")) {
        const std::string& method = row.at("method");
        double n = real(row, "springs"), steps = real(row, "steps_to_cross");
        seen.insert(method);
        if (method == "forward_euler") expect(std::fabs(steps - 2 * n) <= 1, "forward Euler does not need 2n steps");
        else if (method == "symplectic_euler")
            expect(std::fabs(steps - n) <= 1, "symplectic Euler does not need n steps");
        else expect(steps == 1, method + " does not cross in one step");
    }
    expect(seen.size() == 5, "a method is missing");
}

// Every tag closed in order, every number in the drawings finite, nothing fetched from elsewhere.
void the_page_is_well_formed() {
    const std::string page = read(first + "/index.html");
    std::vector<std::string> open;
    std::map<std::string, int> used;
    for (std::size_t at = page.find('<'); at != std::string::npos; at = page.find('<', at + 1)) {
        std::size_t end = page.find('>', at);
        if (end == std::string::npos) break;
        std::string tag = page.substr(at + 1, end - at - 1);
        bool closing = tag[0] == '/', alone = tag.back() == '/' || tag[0] == '!';
        std::string name = tag.substr(closing, tag.find_first_of(" /\n", closing) - closing);
        if (alone || name == "meta") continue;
        if (!closing) {
            open.push_back(name);
            ++used[name];
        } else {
            expect(!open.empty() && open.back() == name,
                   "</" + name + "> closes <" + (open.empty() ? "" : open.back()) + ">");
            if (!open.empty()) open.pop_back();
        }
    }
    expect(open.empty(), "a tag is not closed");
    expect(used["svg"] > 12 && used["table"] >= 5 && used["figure"] > 8, "figures or tables are missing");
    expect(used["section"] == 7, "a section is missing");
    expect(used["script"] == 0, "the page needs a script");
    for (const char* bad :
         {"=\"nan", "=\"inf", "=\"-nan", "=\"-inf", " nan ", ">nan", "href=\"http", "src=", "url(http"})
        expect(page.find(bad) == std::string::npos, std::string("the page holds ") + bad);
    for (std::size_t at = page.find("href=\""); at != std::string::npos; at = page.find("href=\"", at + 1)) {
        std::string target = page.substr(at + 6, page.find('"', at + 6) - at - 6);
        if (target[0] == '#') expect(page.find("id=\"" + target.substr(1) + "\"") != std::string::npos, "no " + target);
        else read(first + "/" + target);
    }
}

void the_summary_has_stable_keys() {
    std::istringstream text(read(first + "/summary.txt")), again(read(second + "/summary.txt"));
    auto keys = [](std::istream& lines) {
        std::vector<std::string> found;
        for (std::string line; std::getline(lines, line);) {
            std::size_t colon = line.find(": ");
            expect(colon != std::string::npos && colon + 2 < line.size(), "not `key: value`: " + line);
            expect(line.find("nan") == std::string::npos, "not a number: " + line);
            found.push_back(line.substr(0, colon));
        }
        return found;
    };
    std::vector<std::string> here = keys(text), there = keys(again);
    expect(here.size() > 30, "fewer than 30 main figures");
    expect(std::set<std::string>(here.begin(), here.end()).size() == here.size(), "a key comes twice");
    for (const char* key :
         {"chain.growth.exponent.implicit_half.float64", "chain.hanging.n1000.implicit_one.stretch",
          "chain.figure2.largest_relative_error", "chain.extremes.library.worst_position_error_after_1_step"})
        expect(std::set<std::string>(here.begin(), here.end()).count(key) == 1, std::string("no key ") + key);
}

}  // namespace

int main(int argc, char** argv) {
    const std::map<std::string, std::function<void()>> checks = {
        {"outcomes_repeat", outcomes_repeat},
        {"errors_fall_at_their_order", errors_fall_at_their_order},
        {"stiff_chains_agree_and_the_textbook_does_not", stiff_chains_agree_and_the_textbook_does_not},
        {"explicit_steps_need_many_on_a_stiff_chain", explicit_steps_need_many_on_a_stiff_chain},
        {"the_hanging_rope_stretches_as_it_should", the_hanging_rope_stretches_as_it_should},
        {"figure_2_is_exact", figure_2_is_exact},
        {"a_disturbance_crosses_as_claimed", a_disturbance_crosses_as_claimed},
        {"the_page_is_well_formed", the_page_is_well_formed},
        {"the_summary_has_stable_keys", the_summary_has_stable_keys},
    };
    if (argc != 4 || checks.count(argv[1]) == 0) {
        std::fprintf(stderr, "usage: report_check CHECK FIRST SECOND\n");
        return 2;
    }
    first = argv[2];
    second = argv[3];
    checks.at(argv[1])();
    return failures == 0 ? 0 : 1;
}
