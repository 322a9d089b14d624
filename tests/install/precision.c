/* Which precisions this build can do: prints what cd_chain_create and cd_membrane_create give for each. */
#include <contdyn/contdyn.h>

#include <stdio.h>

static const char* made(cd_precision precision) {
    cd_chain* chain = NULL;
    cd_membrane* membrane = NULL;
    const cd_status status = cd_chain_create(1, 4, 3, precision, NULL, &chain);
    const cd_status of_membrane = cd_membrane_create(4, 4, 3, precision, NULL, &membrane);
    if ((status == CD_OK) != (chain != NULL)) return "a chain that does not go with the status";
    if ((of_membrane == CD_OK) != (membrane != NULL)) return "a membrane that does not go with the status";
    if (membrane && cd_membrane_step(membrane, 0.01, 2)) return cd_error_message();
    cd_chain_destroy(chain);
    cd_membrane_destroy(membrane);
    return of_membrane == status ? cd_status_name(status) : "another status for a membrane than for a chain";
}

int main(void) {
    printf("float32 %s\n", made(CD_FLOAT32));
    printf("float64 %s\n", made(CD_FLOAT64));
    return 0;
}
