// Run times that can be compared: all jobs in one process, taking turns, the first run of each left out.
#ifndef REPORT_TIMING_HPP
#define REPORT_TIMING_HPP

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

namespace report {

inline double now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

struct Job {
    std::function<void()> prepare;  // not timed, before every run
    std::function<void()> run;      // timed
    double first = 0;               // how long a run took that came before, if there was one
    std::vector<double> seconds = {};  // of the runs that count, sorted once time_in_turns is done

    double least() const { return seconds.front(); }
    double median() const { return seconds[seconds.size() / 2]; }
    double upper_quartile() const { return seconds[seconds.size() * 3 / 4]; }

    // A quarter of the runs took so much longer than the least, as a share of it; NaN of fewer than four.
    double spread() const { return seconds.size() < 4 ? NAN : upper_quartile() / least() - 1; }
};

// The spread of every job that was timed at least four times.
inline std::vector<double>& spreads() {
    static std::vector<double> all;
    return all;
}

// Runs every job once untimed, unless that has been done, then in turns: as many rounds as fit `budget` seconds a job,
// at least `least` and at most `most`; of a run so long that it averages by itself, one.
inline void time_in_turns(std::vector<Job>& jobs, double budget, std::size_t least, std::size_t most) {
    auto timed = [](Job& job) {
        job.prepare();
        double start = now();
        job.run();
        return now() - start;
    };
    std::vector<std::size_t> rounds;
    for (Job& job : jobs) {
        double first = std::max(job.first > 0 ? job.first : timed(job), 1e-7);
        const std::size_t wanted = first > 0.3 ? 1 : least;
        rounds.push_back(std::min(most, std::max(wanted, std::size_t(std::min(budget / first, 1e6)))));
    }
    for (std::size_t round = 0; round < most; ++round)
        for (std::size_t i = 0; i < jobs.size(); ++i)
            if (round < rounds[i]) jobs[i].seconds.push_back(timed(jobs[i]));
    for (Job& job : jobs) {
        std::sort(job.seconds.begin(), job.seconds.end());
        if (!std::isnan(job.spread())) spreads().push_back(job.spread());
    }
}

}  // namespace report

#endif
