// A random chain and the calls that only chains have.
#ifndef FUZZ_CHAIN_HPP
#define FUZZ_CHAIN_HPP

#include "body.hpp"

namespace fuzz {

class Chain : public Body<ChainApi> {
public:
    Chain();

protected:
    cd_status make(const cd_allocator* allocator, cd_chain** out) override;
    bool extent(cd_field field, Extent& out) const override;
    cd_status view(cd_chain* handle, cd_field field, View& out) const override;
    void act_by_kind() override;
    void check_state() override;
    double energy() const override;
    double stiffest() const override;
    double heaviest() const override;
    double gravity() const override;
    bool is_ring() const override { return springs_now() > springs; }
    bool is_driven() const override;
    bool keeps_its_energy() const override { return true; }

private:
    size_t strands, springs;

    size_t springs_now() const; // a ring has one more
    void impulse();
    void attach();
    void detach();
    void get_attachment();
    void cut_or_weld();
    void set_end();
    void get_end();
    void sample();
    void get_shape();
    void get_parameter();
};

} // namespace fuzz

#endif
