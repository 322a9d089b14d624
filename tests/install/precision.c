/* Which precisions this build can do: prints what cd_chain_create gives for each. */
#include <contdyn/contdyn.h>

#include <stdio.h>

static const char* made(cd_precision precision) {
    cd_chain* chain = NULL;
    const cd_status status = cd_chain_create(1, 4, 3, precision, NULL, &chain);
    if ((status == CD_OK) != (chain != NULL)) return "a chain that does not go with the status";
    cd_chain_destroy(chain);
    return cd_status_name(status);
}

int main(void) {
    printf("float32 %s\n", made(CD_FLOAT32));
    printf("float64 %s\n", made(CD_FLOAT64));
    return 0;
}
