// Twins with fields, which are written, read and viewed by chance.
#ifndef FUZZ_FIELDED_HPP
#define FUZZ_FIELDED_HPP

#include <initializer_list>

#include "arguments.hpp"
#include "twins.hpp"

namespace fuzz {

template <class Api> class Fielded : public Twins<Api> {
public:
    using Handle = typename Api::Handle;

protected:
    // How large a field is; false if there is no such field.
    virtual bool extent(cd_field field, Extent& out) const = 0;
    virtual cd_status view(Handle* handle, cd_field field, View& out) const = 0;

    // A whole field; false if it is not switched on.
    bool read_all(Handle* handle, cd_field field, Doubles& out) const;
    bool read_all(cd_field field, Doubles& out) const { return read_all(this->first(), field, out); }
    Doubles all_of(cd_field field) const;                            // empty if it is not switched on
    double largest_of(std::initializer_list<cd_field> fields) const; // INFINITY if a number of them is not finite

    void write_by_chance();
    void read_by_chance();
    void view_by_chance();
    void enable_by_chance();
    void disable_by_chance();
    void print_difference() override;

private:
    cd_field pick_own_field() const;
    Part pick_part_of(cd_field field) const;
    template <class Number, class Function> void write_as(Function function, const char* what, cd_field field);
    template <class Number, class Function> void read_as(Function function, const char* what, cd_field field);
};

} // namespace fuzz

#endif
