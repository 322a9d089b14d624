// Random water and the calls that only water has.
#ifndef FUZZ_WATER_HPP
#define FUZZ_WATER_HPP

#include "object.hpp"

namespace fuzz {

class Water : public Object<WaterApi> {
public:
    Water();

protected:
    cd_status make(const cd_allocator* allocator, cd_water** out) override;
    bool extent(cd_field field, Extent& out) const override;
    cd_status view(cd_water* handle, cd_field field, View& out) const override;
    void act_by_kind() override;
    void check_state() override;
    double state_size() const override;
    bool is_driven() const override; // by sources or at its sides
    void before_step(double dt) override;
    void after_step(const Step& step) override;

private:
    size_t nx, ny;
    double new_dx, new_dy; // of a new water; a load brings the size of its own cells

    struct Lengths {
        double x, y;
    };
    Lengths cell() const;
    Lengths whole() const;

    // What the account tells, and the volume.
    struct Account {
        double initial, in, out, error, volume;
    };
    Account before = {};
    Account account() const;
    void check_account(const Step& step);
    void check_faces(bool along_y) const;

    // In water_calls.cpp.
    struct Disc {
        double x, y, radius;
    };
    Disc pick_disc() const;
    struct Rectangle {
        size_t x, y, columns, rows;
    };
    Rectangle pick_rectangle() const;
    double pick_amount(double most) const; // of either sign
    void set_side();
    void set_inflow_depth();
    void add_volume();
    void add_volume_rectangle();
    void add_source();
    void add_source_rectangle();
    void splash();
    void impulse();
    void restart_account();
    void set_hulls();
    void set_hull();
    void place_hull();
    void drive_hull();
    void get_hull();

    // In water_reads.cpp.
    void get_measures();
    void get_account();
    void get_limited();
    void get_side();
    void get_shape();
    void get_parameter();
    void sample();
    void write_vertices();
    void write_indices();
};

} // namespace fuzz

#endif
