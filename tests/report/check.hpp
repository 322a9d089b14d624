// What the checks of the report's sample share. Never a time.
#ifndef REPORT_CHECK_HPP
#define REPORT_CHECK_HPP

#include <functional>
#include <map>
#include <string>
#include <vector>

using Row = std::map<std::string, std::string>;
using Checks = std::map<std::string, std::function<void()>>;

extern std::string first, second;  // the folders of the two runs
extern std::string source;         // the project's folder
extern int failures;

void expect(bool good, const std::string& what);
std::string read(const std::string& path);
double real(const Row& row, const std::string& column);
std::vector<Row> rows_of(const std::string& name);  // of a CSV file of the first run

// Each method's exponent of error ~ dt^p over its five finest float64 steps of a case is the one given.
void expect_orders(const std::string& file, const std::string& study, const std::map<std::string, double>& orders);

Checks chain_checks();
Checks membrane_checks();
Checks water_checks();
Checks atlas_checks();
Checks readme_checks();

#endif
