// What the tests of contdyn.hpp share: checks that end the program, and calls that work or are refused, whether errors
// are thrown or returned.
#ifndef CHECK_HPP
#define CHECK_HPP

#include <contdyn/contdyn.hpp>

#include <cstdio>
#include <cstdlib>
#include <cstring>

[[noreturn]] inline void fail(const char* file, int line, const char* what, const char* why = "") {
    std::fprintf(stderr, "%s:%d: %s %s\n", file, line, what, why);
    std::exit(1);
}

#define CHECK(...)                                                  \
    do {                                                            \
        if (!(__VA_ARGS__)) fail(__FILE__, __LINE__, #__VA_ARGS__); \
    } while (0)

// GET(call) is what a call that must succeed gives; REFUSED(status, piece, call) must fail, with the piece of text in
// its message; OK(call) must succeed.
#if CONTDYN_EXCEPTIONS

#define OK(...) (__VA_ARGS__)
#define GET(...) (__VA_ARGS__)
#define REFUSED(wanted, piece, ...)                                                                  \
    do {                                                                                             \
        bool threw = false;                                                                          \
        try {                                                                                        \
            static_cast<void>(__VA_ARGS__);                                                          \
        } catch (const contdyn::error& e) {                                                          \
            threw = true;                                                                            \
            if (e.status() != (wanted)) fail(__FILE__, __LINE__, #__VA_ARGS__, e.what());            \
            if (!std::strstr(e.what(), piece)) fail(__FILE__, __LINE__, #__VA_ARGS__, e.what());     \
            if (std::strcmp(e.what(), contdyn::error_message()) != 0) fail(__FILE__, __LINE__, "?"); \
        }                                                                                            \
        if (!threw) fail(__FILE__, __LINE__, #__VA_ARGS__, "does not throw");                        \
    } while (0)

#else

inline contdyn::status status_of(contdyn::status s) { return s; }
template <class T> contdyn::status status_of(const contdyn::result<T>& r) { return r.status(); }

template <class T> T get(contdyn::result<T> r, const char* file, int line, const char* what) {
    if (!r) fail(file, line, what, contdyn::error_message());
    return std::move(r).value();
}

#define OK(...)                                                               \
    do {                                                                      \
        if (status_of(__VA_ARGS__) != contdyn::status::ok)                    \
            fail(__FILE__, __LINE__, #__VA_ARGS__, contdyn::error_message()); \
    } while (0)
#define GET(...) get(__VA_ARGS__, __FILE__, __LINE__, #__VA_ARGS__)
#define REFUSED(wanted, piece, ...)                                                                                   \
    do {                                                                                                              \
        if (status_of(__VA_ARGS__) != (wanted)) fail(__FILE__, __LINE__, #__VA_ARGS__, contdyn::error_message());     \
        if (!std::strstr(contdyn::error_message(), piece)) fail(__FILE__, __LINE__, piece, contdyn::error_message()); \
    } while (0)

#endif

#endif
