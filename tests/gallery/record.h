/* Included before a guide it has the guide's objects drawn while they are stepped: when the program ends, record.c writes
 * what it saw as a moving picture to the file that the environment variable CONTDYN_PICTURE names. */
#ifndef GALLERY_RECORD_H
#define GALLERY_RECORD_H

#include <contdyn/contdyn.h>

cd_status record_chain_step(cd_chain* chain, double dt, size_t count);
cd_status record_membrane_step(cd_membrane* membrane, double dt, size_t count);
cd_status record_water_step(cd_water* water, double dt, size_t count);
void record_chain_destroy(cd_chain* chain);
void record_membrane_destroy(cd_membrane* membrane);
void record_water_destroy(cd_water* water);

#ifndef GALLERY_RECORDS
#define cd_chain_step record_chain_step
#define cd_membrane_step record_membrane_step
#define cd_water_step record_water_step
#define cd_chain_destroy record_chain_destroy
#define cd_membrane_destroy record_membrane_destroy
#define cd_water_destroy record_water_destroy
#endif

#endif
