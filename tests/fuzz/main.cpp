// A fuzzer of the whole public API: random calls with good and bad arguments, from a seed.
//
//   fuzz SEED SECONDS                   runs sequences 0, 1, 2 ... of this seed for so long
//   fuzz SEED --sequences COUNT         runs so many: the same work whatever the machine
//   fuzz SEED SECONDS SEQUENCE [min]    runs that one alone and prints its calls; min: leaves out calls as long as a
//                                       problem of the same kind stays, then prints those that are left. The file
//                                       that FUZZ_DUMP names gets what the last step began with, as bytes to load
//
// The environment variable FUZZ_ONLY names the kinds of objects to take, such as chain,membrane; otherwise all.
//
// A sequence makes 1 to 4 objects, each of them twice, and makes random calls on both with the same arguments. The
// first has random kernels, a parallel hook and an allocator that fails now and then; its twin has other kernels and
// none of the rest. After every call:
//   - statuses, outputs and hashes of the two agree, bit for bit
//   - a failed call has changed nothing: hash, memory held, outputs
//   - calls that may not allocate have not, neither from the allocator nor, where AddressSanitizer watches, by malloc
//   - get_memory tells what the allocator gave; at the end of a sequence it has got all of it back
//   - depths are >= 0, what is pinned, absent or closed is still, volume keeps to its account, and numbers are finite
//     unless CD_ERROR_DIVERGED told otherwise
//   - in "sane" sequences, whose numbers are moderate, lambda >= 1/2 never diverges and adds no energy to what nothing
//     drives; a step of a rope that is content leaves springs as long as their tensions make them, and adds no more
//     energy than its tolerance is worth
// Twins are made again by save and load or by copy_state, and go on in step with the first. Objects go back to earlier
// states and take over those of others. Saved bytes are damaged, which must be refused; with the checksum put right
// they must be refused or give a state that calls could have made.
//
// Sequences run in child processes: one that dies or hangs is reported and passed over. Each problem is one line on
// stdout that begins with PROBLEM and names the seed and the sequence. Exit status 0: no problem was found.
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "heap.hpp"
#include "run.hpp"
#include "sequence.hpp"

namespace fuzz {

// ---- many sequences ------------------------------------------------------------------------------------------------

struct Goal {
    double end = 0;         // by the clock, or
    uint64_t sequences = 0; // how many, if not 0
};

static double now() {
    timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return double(t.tv_sec) + double(t.tv_nsec) * 1e-9;
}

static bool is_reached(const Goal& goal) {
    return goal.sequences ? totals->next_sequence >= goal.sequences : now() >= goal.end;
}

[[noreturn]] static void run_some(const Goal& goal) {
    for (int k = 0; k < 400 && !is_reached(goal); ++k) {
        run_sequence(totals->next_sequence++, {});
    }
    exit(0);
}

static void run_children(const Goal& goal) {
    while (!is_reached(goal)) {
        fflush(stdout);
        const pid_t child = fork();
        if (child == 0) run_some(goal);
        int status = 0;
        waitpid(child, &status, 0);
        if (WIFEXITED(status) && WEXITSTATUS(status) == 0) continue;
        ++totals->deaths;
        printf("PROBLEM seed %llu sequence %llu: died, %s %d\n", static_cast<unsigned long long>(run.seed),
               static_cast<unsigned long long>(totals->next_sequence - 1),
               WIFSIGNALED(status) ? "signal" : "exit status",
               WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status));
    }
}

static void print_totals() {
    const struct {
        const char* what;
        uint64_t count;
    } all[] = {{"sequences", totals->sequences},
               {"calls, each on two objects", totals->calls},
               {"refused", totals->refused},
               {"out of memory", totals->out_of_memory},
               {"steps", totals->steps},
               {"calls that diverged", totals->diverged},
               {"that ended short of a tolerance", totals->short_of_tolerance},
               {"changed bytes refused", totals->bytes_refused},
               {"taken", totals->bytes_taken},
               {"problems", totals->problems},
               {"deaths", totals->deaths}};
    for (const auto& one : all)
        printf("%s%s %llu", &one == all ? "" : "; ", one.what, static_cast<unsigned long long>(one.count));
    printf("\n");
}

// ---- one sequence --------------------------------------------------------------------------------------------------

// How a sequence ends in a process of its own, without what it says: 0 if there is no problem.
static int outcome(uint64_t sequence, const std::vector<bool>& left_out) {
    fflush(stdout);
    const pid_t child = fork();
    if (child == 0) {
        if (!freopen("/dev/null", "w", stdout) || !freopen("/dev/null", "w", stderr)) _exit(3);
        run_sequence(sequence, left_out);
        _exit(totals->problems ? run.first_kind : 0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    totals->problems = 0;
    return status;
}

static std::vector<bool> calls_to_leave_out(uint64_t sequence) {
    std::vector<bool> left_out(kMostCalls, false);
    const int wanted = outcome(sequence, left_out);
    if (wanted == 0) return left_out;
    for (size_t chunk = 64; chunk > 0; chunk /= 2)
        for (size_t first = 0; first < kMostCalls; first += chunk) {
            const std::vector<bool> before = left_out;
            for (size_t k = first; k < first + chunk && k < kMostCalls; ++k) left_out[k] = true;
            if (left_out != before && outcome(sequence, left_out) != wanted) left_out = before;
        }
    return left_out;
}

} // namespace fuzz

using namespace fuzz;

int main(int argc, char** argv) {
    if (argc < 3) {
        fprintf(stderr, "usage: fuzz SEED SECONDS [SEQUENCE [min]]\n       fuzz SEED --sequences COUNT\n");
        return 2;
    }
    const char* const only = getenv("FUZZ_ONLY");
    if (only && !strstr(only, "chain") && !strstr(only, "membrane") && !strstr(only, "water")) {
        fprintf(stderr, "FUZZ_ONLY names no kind of object: chain, membrane, water\n");
        return 2;
    }
    run.seed = strtoull(argv[1], nullptr, 10);
    void* const shared = mmap(nullptr, sizeof(Totals), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (shared == MAP_FAILED) return perror("mmap"), 2;
    totals = new (shared) Totals();
    malloc_watch::install();
    const bool by_count = strcmp(argv[2], "--sequences") == 0 && argc > 3;
    if (argc > 3 && !by_count) {
        const uint64_t sequence = strtoull(argv[3], nullptr, 10);
        const std::vector<bool> left_out = argc > 4 ? calls_to_leave_out(sequence) : std::vector<bool>();
        run.tracing = true;
        run_sequence(sequence, left_out);
        return totals->problems ? 1 : 0;
    }
    Goal goal;
    if (by_count) goal.sequences = strtoull(argv[3], nullptr, 10);
    else goal.end = now() + atof(argv[2]);
    run_children(goal);
    print_totals();
    return totals->problems || totals->deaths ? 1 : 0;
}
