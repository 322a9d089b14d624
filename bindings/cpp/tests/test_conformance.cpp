// Plays the scenes that every binding plays, and compares the hashes of their states.
#include "check.hpp"

#include "reader.h"

#include <optional>
#include <string>

namespace {

struct object {
    std::optional<contdyn::chain> chain;
    std::optional<contdyn::membrane> membrane;
    std::optional<contdyn::water> water;
};

object create(const arguments& call, contdyn::kernels kernels) {
    const std::string kind = call.statement->words[1];
    const auto p = static_cast<contdyn::precision>(call.precision);
    const auto z = [&](std::size_t k) { return size_argument(&call, k); };
    object made;
    if (kind == "chain") made.chain = GET(contdyn::chain::create(z(0), z(1), z(2), p));
    else if (kind == "membrane") made.membrane = GET(contdyn::membrane::create(z(0), z(1), z(2), p));
    else if (kind == "water")
        made.water = GET(contdyn::water::create(z(0), z(1), number_argument(&call, 2), number_argument(&call, 3), p));
    else fail_at(call.statement, "no object", call.statement->words[1]);
    if (made.chain) OK(made.chain->set_kernels(kernels));
    if (made.membrane) OK(made.membrane->set_kernels(kernels));
    if (made.water) OK(made.water->set_kernels(kernels));
    return made;
}

std::uint64_t hash_of(const object& o) {
    return o.chain ? GET(o.chain->hash()) : o.membrane ? GET(o.membrane->hash()) : GET(o.water->hash());
}

#if CONTDYN_EXCEPTIONS
template <class Call> contdyn::status status_of_call(const Call& call) {
    try {
        static_cast<void>(call());
    } catch (const contdyn::error& e) {
        return e.status();
    }
    return contdyn::status::ok;
}
#else
template <class Call> contdyn::status status_of_call(const Call& call) { return status_of(call()); }
#endif

#define D(k) number_argument(&call, k)
#define Z(k) size_argument(&call, k)
#define I(k) (number_argument(&call, k) != 0)
#define E(type, k) static_cast<contdyn::type>(enum_argument(&call, k))
#define A(k) doubles(array_argument(&call, k))
#define P(k) A(k)
#define F(k) floats(array_argument(&call, k))
#define OUT
#define CHAIN(name, ...) TRY(chain, name, o.chain->name(__VA_ARGS__))
#define CHAIN_0(name) TRY(chain, name, o.chain->name())
#define MEMBRANE(name, ...) TRY(membrane, name, o.membrane->name(__VA_ARGS__))
#define MEMBRANE_0(name) TRY(membrane, name, o.membrane->name())
#define WATER(name, ...) TRY(water, name, o.water->name(__VA_ARGS__))
#define WATER_0(name) TRY(water, name, o.water->name())
#define TRY(kind, name, call_of_it) \
    if (o.kind && word == #name) return status_of_call([&] { return call_of_it; });

std::vector<double> doubles(const numbers& n) { return {n.values, n.values + n.count}; }
std::vector<float> floats(const numbers& n) { return {n.singles, n.singles + n.count}; }

contdyn::status perform(object& o, const arguments& call) {
    const std::string word = call.statement->words[call.first];
#include "calls.h"
    fail_at(call.statement, "no call", call.statement->words[call.first]);
    return contdyn::status::ok;
}

void hold(const statement& where, contdyn::status got, contdyn::status wanted) {
    if (got == wanted) return;
    std::fprintf(stderr, "line %zu: %s, not %s: %s\n", where.line, contdyn::status_name(got),
                 contdyn::status_name(wanted), contdyn::error_message());
    std::exit(1);
}

void copy(object& to, const object& from) {
    if (from.chain) OK(to.chain->copy_state(*from.chain));
    if (from.membrane) OK(to.membrane->copy_state(*from.membrane));
    if (from.water) OK(to.water->copy_state(*from.water));
}

void save_and_load(object& to, const object& from) {
    if (from.chain) OK(to.chain->load(GET(from.chain->save())));
    if (from.membrane) OK(to.membrane->load(GET(from.membrane->save())));
    if (from.water) OK(to.water->load(GET(from.water->save())));
}

// How many hashes were compared.
std::size_t play(const char* text, cd_precision precision, contdyn::kernels kernels) {
    static statement now, made;
    std::size_t compared = 0, at = 0, line = 1;
    std::string scene;
    object o;
    while (next_statement(text, &at, &line, &now)) {
        const std::string word = now.words[0];
        arguments call = {&now, 0, precision};
        if (word == "scene") {
            scene = now.words[1];
            o = {};
        } else if (word == "create") {
            call.first = 1;
            o = create(call, kernels);
            made = now;
            for (std::size_t i = 0; i < now.count; ++i) made.words[i] = made.text + (now.words[i] - now.text);
        } else if (word == "copy" || word == "save_and_load") {
            object other = create({&made, 1, precision}, kernels);
            word == "copy" ? copy(other, o) : save_and_load(other, o);
            o = std::move(other);
        } else if (word == "hash") {
            const std::uint64_t wanted = std::strtoull(now.words[precision == CD_FLOAT64 ? 2 : 1], nullptr, 16);
            if (hash_of(o) != wanted) fail_at(&now, "another hash in scene", scene.c_str());
            ++compared;
        } else if (word == "refused") {
            call.first = 2;
            hold(now, perform(o, call), static_cast<contdyn::status>(enumerator_of(&now, now.words[1])));
        } else {
            hold(now, perform(o, call), contdyn::status::ok);
        }
    }
    return compared;
}

} // namespace

int main(int count, char** arguments) {
    if (count != 2) return std::fprintf(stderr, "test_conformance SCENES.TXT\n"), 2;
    char* text = read_text(arguments[1]);
    std::size_t compared = 0;
    for (contdyn::kernels kernels : contdyn::runnable_kernels())
        for (cd_precision precision : {CD_FLOAT32, CD_FLOAT64}) compared += play(text, precision, kernels);
    std::free(text);
    std::printf("%zu hashes compared\n", compared);
    return compared == 0;
}
