/* A program as another compiler makes it: it knows the headers, the import library and the DLL, and of Windows nothing
 * but three functions. It writes the hash of a rope that has swung. */
#include <contdyn/contdyn.h>

__declspec(dllimport) void __stdcall ExitProcess(unsigned code);
__declspec(dllimport) void* __stdcall GetStdHandle(unsigned which);
__declspec(dllimport) int __stdcall WriteFile(void* file, const void* bytes, unsigned count, unsigned* written, void*);

int _fltused = 0; /* Microsoft's linker looks for it where there are floating-point numbers */

static void refuse_to_work_on(cd_status status) {
    if (status) ExitProcess((unsigned)status);
}

void start(void) {
    const double gravity[2] = {0, -9.81};
    cd_chain* rope = 0;
    uint64_t hash = 0;
    char digits[16];
    unsigned written;

    refuse_to_work_on(cd_chain_create(1, 100, 2, CD_FLOAT64, 0, &rope));
    refuse_to_work_on(cd_chain_set_rest_length(rope, 1));
    refuse_to_work_on(cd_chain_set_gravity(rope, gravity, 2));
    refuse_to_work_on(cd_chain_set_end(rope, CD_END_FIRST, CD_NODE_PINNED));
    refuse_to_work_on(cd_chain_step(rope, 1 / 60.0, 60));
    refuse_to_work_on(cd_chain_hash(rope, &hash));
    cd_chain_destroy(rope);
    for (int i = 0; i < 16; ++i) digits[i] = "0123456789abcdef"[hash >> (60 - 4 * i) & 15];
    WriteFile(GetStdHandle((unsigned)-11), digits, sizeof digits, &written, 0);
    ExitProcess(0);
}
