// One object of a sequence, whatever its kind: what is done with it by chance, and what must hold after every step.
#ifndef FUZZ_OBJECT_HPP
#define FUZZ_OBJECT_HPP

#include <math.h>

#include "kept.hpp"

namespace fuzz {

class AnyObject {
public:
    virtual ~AnyObject() = default;
    virtual void act() = 0; // a random call
    virtual void* handle() const = 0;
    // A random call in the place of whose object there is null, or an object of another kind.
    virtual void misuse(void* other) = 0;
    // Takes the state of another object; false if that is of another kind.
    virtual bool take(AnyObject& other) = 0;
};

// A call of cd_*_step, and what the object was before it.
struct Step {
    double dt;
    size_t count;
    cd_status status;
    double size_before, stable_dt_before;
    uint64_t steps_before, hash_before;
};

template <class Api> class Object : public Kept<Api>, public AnyObject {
public:
    using Handle = typename Api::Handle;

    void act() override;
    void* handle() const override { return this->first(); }
    void misuse(void* other) override;
    bool take(AnyObject& other) override;

protected:
    virtual void act_by_kind() = 0;        // a call that only this kind of object has
    virtual double state_size() const = 0; // the largest of its numbers; INFINITY if one is not finite
    virtual bool is_driven() const = 0;    // whether something but springs and gravity works on it
    bool is_finite() const { return state_size() < HUGE_VAL; }
    virtual void before_step(double dt) = 0;
    virtual void after_step(const Step& step) = 0;

private:
    void step();
    void check_step(const Step& step);
    void reset();
    void set_lambda();
    void set_parallel();
    void get_something();
};

} // namespace fuzz

#endif
