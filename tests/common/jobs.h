/* Ways to run a chain's parallel work, for cd_chain_set_parallel. */
#ifndef JOBS_H
#define JOBS_H

#include <stddef.h>

#include <contdyn/base.h>

/* `user` of each table points to one: how often run was called and how many tasks it ran. */
struct jobs {
    size_t runs, tasks;
};

cd_parallel jobs_reversed(struct jobs* jobs); /* one after the other, the last first */
cd_parallel jobs_threads(struct jobs* jobs);  /* two threads that take turns at the next task */

#endif
