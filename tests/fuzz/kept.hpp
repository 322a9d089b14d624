// Twins that are saved, loaded and copied by chance: whole, damaged, and with contents that no call wrote.
#ifndef FUZZ_KEPT_HPP
#define FUZZ_KEPT_HPP

#include <vector>

#include "fielded.hpp"

namespace fuzz {

using Bytes = std::vector<unsigned char>;

template <class Api> class Kept : public Fielded<Api> {
protected:
    using Handle = typename Api::Handle;

    Bytes saved(); // by the first of the two

    // What holds for every state that calls can make, such as that pinned nodes rest.
    virtual void check_state() = 0;

    void save_into_too_little();
    void remake_twin();  // by save and load, or by copy; it goes on in the old one's place
    void keep();         // remembers the state
    void go_back();      // to one that was remembered, by load or by copy
    void load_damaged(); // damaged, refused; or damaged, and with the right checksum: refused, or of use
    void take_another(Kept& other, bool by_copy); // the state of another object of this kind

private:
    struct State {
        Bytes bytes;
        uint64_t hash;
        Past past;
    };
    std::vector<State> states;

    void check_crafted(const Bytes& crafted);
};

} // namespace fuzz

#endif
