// One problem behind the same few verbs, whatever it is of and whether the library runs it or the textbook.
#ifndef REPORT_RUNNER_HPP
#define REPORT_RUNNER_HPP

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "method.hpp"

namespace report {

class Runner {
public:
    virtual ~Runner() = default;
    virtual void reset() = 0;                             // the initial state; the next step factors anew
    virtual bool step(double dt, std::size_t count) = 0;  // false: left the finite range, or short of the tolerance
    virtual std::vector<double> positions() const = 0;
    virtual std::vector<double> velocities() const = 0;
    virtual std::uint64_t hash() const = 0;
    virtual std::size_t iterations() const { return 0; }  // the most that a solve of the last call of step took
};

using MakeRunner = std::function<std::unique_ptr<Runner>(const Method&, cd_precision)>;

// FNV-1a of the bytes of numbers: continues a hash.
const std::uint64_t kHashStart = 0xcbf29ce484222325u;
template <class Real> std::uint64_t hash_of(const std::vector<Real>& values, std::uint64_t hash) {
    for (const Real& value : values) {
        const unsigned char* bytes = reinterpret_cast<const unsigned char*>(&value);
        for (std::size_t i = 0; i < sizeof(Real); ++i) hash = (hash ^ bytes[i]) * 0x100000001b3u;
    }
    return hash;
}

}  // namespace report

#endif
