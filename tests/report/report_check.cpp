// report_check CHECK FIRST SECOND [SOURCE]: looks at what two runs of the report's sample wrote into FIRST and
// SECOND, and into the README.
#include <cmath>
#include <cstdio>
#include <fstream>
#include <set>
#include <sstream>

#include "check.hpp"
#include "page.hpp"

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

void expect_orders(const std::string& file, const std::string& study, const std::map<std::string, double>& orders) {
    std::map<std::string, std::map<double, double>> errors;  // by method and dt
    for (const Row& row : rows_of(file))
        if (row.at("case") == study && row.at("precision") == "float64" && real(row, "error") > 1e-9)
            errors[row.at("method")][real(row, "dt_s")] = real(row, "error");
    for (const auto& [method, order] : orders) {
        double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
        for (const auto& [dt, error] : errors[method]) {
            if (n == 5) break;
            double x = std::log(dt), y = std::log(error);
            n += 1, sx += x, sy += y, sxx += x * x, sxy += x * y;
        }
        double slope = (n * sxy - sx * sy) / (n * sxx - sx * sx);
        expect(n == 5 && std::fabs(slope - order) < 0.1,
               study + ": " + method + " is of order " + std::to_string(slope));
    }
}

namespace {

void outcomes_repeat() {
    for (const char* name : {"outcomes.csv", "chain_figure2.csv", "chain_crossing.csv", "chain_extremes.csv",
                             "scene_rope.csv", "membrane_blow_ups.csv",
                             "membrane_frequencies.csv", "membrane_iterations.csv", "membrane_load.csv",
                             "water_thacker.csv", "water_dam.csv", "water_lake.csv", "water_storm.csv",
                             "water_any_step.csv", "chain_atlas.csv", "membrane_atlas.csv", "water_atlas.csv",
                             "water_shores.csv", "notes_misprints.csv"})
        expect(read(first + "/" + name) == read(second + "/" + name), std::string(name) + " differs between two runs");
    expect(rows_of("outcomes.csv").size() > 900, "fewer than 900 outcomes are hashed");
}

void the_page_is_small() {
    const std::size_t bytes = read(first + "/index.html").size();
    expect(bytes <= report::kPageBudget, "the page takes " + std::to_string(bytes) + " bytes");
}

void tables_have_captions_and_scopes() {
    const std::string page = read(first + "/index.html");
    std::size_t tables = 0, folded = 0;
    for (std::size_t at = page.find("<table"); at != std::string::npos; at = page.find("<table", at + 1), ++tables) {
        const std::string table = page.substr(at, page.find("</table>", at) - at);
        auto number_of = [&](const std::string& tag) {
            std::size_t found = 0;
            for (std::size_t i = table.find(tag); i != std::string::npos; i = table.find(tag, i + 1)) ++found;
            return found;
        };
        const std::size_t rows = number_of("<tr>") - number_of("<thead>");
        const std::size_t opened = page.rfind("<details>", at), closed = page.rfind("</details>", at);
        const bool is_folded = opened != std::string::npos && (closed == std::string::npos || closed < opened);
        expect(number_of("<caption>") == 1, "a table without caption");
        expect(number_of("<th ") == number_of("<th scope=\"col\"") + rows && rows == number_of("<th scope=\"row\"") &&
                   number_of("<th>") == 0, "a head without scope");
        expect(is_folded == (rows > report::kLongTable), "a table of " + std::to_string(rows) + " rows, folded or not");
        folded += is_folded;
    }
    expect(tables >= 15 && folded > 3 && folded < tables, "tables are missing");
}

void pictures_and_contents_come_first() {
    const std::string page = read(first + "/index.html");
    const std::string head = page.substr(0, page.find("<main>")), rest = page.substr(head.size());
    auto number_of = [](const std::string& text, const std::string& what) {
        std::size_t found = 0;
        for (std::size_t i = text.find(what); i != std::string::npos; i = text.find(what, i + 1)) ++found;
        return found;
    };
    const std::size_t shown = number_of(head, "<use href=\"#shown");
    expect(shown == 6 && number_of(rest, "<g id=\"shown") == shown, "pictures are missing at the head");
    const std::string contents = head.substr(0, head.find("</nav>"));
    expect(number_of(contents, "<a href=\"#") == number_of(rest, "<section id=\""), "the contents lack a section");
    expect(contents.find("<h1>") == std::string::npos, "the contents are not first");
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
    expect(used["svg"] > 60 && used["table"] >= 15 && used["figure"] > 30, "figures or tables are missing");
    expect(used["section"] == 32, "a section is missing");
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
    expect(here.size() > 100, "fewer than 100 main figures");
    expect(std::set<std::string>(here.begin(), here.end()).size() == here.size(), "a key comes twice");
    for (const char* key :
         {"chain.growth.exponent.implicit_half.float64", "chain.swing.n100.strands1.half.1e-6.end_missed",
          "chain.figure2.largest_relative_error", "chain.extremes.library.worst_position_error_after_1_step",
          "membrane.drum.n64.at_1_percent.explicit_over_implicit", "membrane.stiff_pair.error_at_64_steps.coupled_half",
          "membrane.growth.exponent.alternating_half.float64", "membrane.iterations.most_but_for_random_springs",
          "membrane.sluggish.coupled_over_alternating_frequency.at_3",
          "membrane.safe.library_greatest_growth_of_speed", "membrane.cloth.n33.one.default.worst_stretch",
          "water.seiche.at_1_percent.explicit_over_implicit", "water.thacker.advected.n200.courant_8",
          "water.stoker.order", "water.lake.textbook_gained", "water.storm.worst_account_error.advected.float64",
          "water.growth.per_cell_exponent.linear_half", "water.cost.ns_per_cell_step.plain", "water.run_up.measured",
          "chain.atlas.differ_from_theory", "membrane.survival.survive", "chain.feature.bytes_per_node.plain",
          "notes.half_life_of_1_s_wave"})
        expect(std::set<std::string>(here.begin(), here.end()).count(key) == 1, std::string("no key ") + key);
}

}  // namespace

int main(int argc, char** argv) {
    Checks checks = {{"outcomes_repeat", outcomes_repeat},
                     {"the_page_is_well_formed", the_page_is_well_formed},
                     {"the_page_is_small", the_page_is_small},
                     {"tables_have_captions_and_scopes", tables_have_captions_and_scopes},
                     {"pictures_and_contents_come_first", pictures_and_contents_come_first},
                     {"the_summary_has_stable_keys", the_summary_has_stable_keys}};
    for (const Checks& more : {chain_checks(), membrane_checks(), water_checks(), atlas_checks(), readme_checks()})
        checks.insert(more.begin(), more.end());
    if (argc < 4 || argc > 5 || checks.count(argv[1]) == 0) {
        std::fprintf(stderr, "usage: report_check CHECK FIRST SECOND [SOURCE]\n");
        return 2;
    }
    first = argv[2];
    second = argv[3];
    if (argc == 5) source = argv[4];
    checks.at(argv[1])();
    return failures == 0 ? 0 : 1;
}
