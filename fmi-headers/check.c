/* Compiles if and only if our header agrees with the official ones.
 *
 * Default: the official headers first, then our prototypes; a prototype that differs is a redeclaration error.
 * With -DOURS: our header alone. Both builds emit the same assertions about the layout of the types. */
#ifdef OURS
#include "flexible_aircraft_fmi2.h"
#else
#include "fmi2Functions.h"

#include "flexible_aircraft_fmi2.h"
#endif

#define SAME(condition) _Static_assert(condition, #condition)

SAME(sizeof(fmi2Real) == 8);
SAME(sizeof(fmi2Integer) == 4);
SAME(sizeof(fmi2Boolean) == 4);
SAME(sizeof(fmi2Byte) == 1);
SAME(sizeof(fmi2ValueReference) == 4);
SAME(sizeof(fmi2Component) == sizeof(void *));
SAME(fmi2OK == 0 && fmi2Warning == 1 && fmi2Discard == 2 && fmi2Error == 3 && fmi2Fatal == 4 && fmi2Pending == 5);
SAME(fmi2ModelExchange == 0 && fmi2CoSimulation == 1);
SAME(fmi2DoStepStatus == 0 && fmi2PendingStatus == 1 && fmi2LastSuccessfulTime == 2 && fmi2Terminated == 3);
SAME(offsetof(fmi2CallbackFunctions, logger) == 0);
SAME(offsetof(fmi2CallbackFunctions, allocateMemory) == sizeof(void *));
SAME(offsetof(fmi2CallbackFunctions, freeMemory) == 2 * sizeof(void *));
SAME(offsetof(fmi2CallbackFunctions, stepFinished) == 3 * sizeof(void *));
SAME(offsetof(fmi2CallbackFunctions, componentEnvironment) == 4 * sizeof(void *));
SAME(sizeof(fmi2CallbackFunctions) == 5 * sizeof(void *));
