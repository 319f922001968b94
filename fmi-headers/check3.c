/* Compiles if and only if our header of FMI 3.0 agrees with the official ones.
 *
 * Default: the official headers first, then our prototypes; a prototype that differs is a redeclaration error.
 * With -DOURS: our header alone. Both builds emit the same assertions about the types. */
#ifdef OURS
#include "flexible_aircraft_fmi3.h"
#else
#include "fmi3Functions.h"

#include "flexible_aircraft_fmi3.h"
#endif

#define SAME(condition) _Static_assert(condition, #condition)

SAME(sizeof(fmi3Float64) == 8 && sizeof(fmi3Float32) == 4);
SAME(sizeof(fmi3Int64) == 8 && sizeof(fmi3Int32) == 4 && sizeof(fmi3Int16) == 2 && sizeof(fmi3Int8) == 1);
SAME(sizeof(fmi3Boolean) == 1 && sizeof(fmi3Clock) == 1 && sizeof(fmi3Byte) == 1);
SAME(sizeof(fmi3ValueReference) == 4);
SAME(sizeof(fmi3Instance) == sizeof(void *) && sizeof(fmi3FMUState) == sizeof(void *));
SAME(fmi3OK == 0 && fmi3Warning == 1 && fmi3Discard == 2 && fmi3Error == 3 && fmi3Fatal == 4);
SAME(fmi3Independent == 0 && fmi3Dependent == 5);
SAME(fmi3IntervalNotYetKnown == 0 && fmi3IntervalChanged == 2);
